#include "clock/shared_slot.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <atomic>
#include <thread>
#include <vector>

#include "clock/child.hpp"

namespace mrroc::clock {
namespace {

// large, so that loads and stores are often interrupted half-way
using Value = std::array<std::uint64_t, 1000>;

Value all(std::uint64_t number) {
  Value value;
  value.fill(number);
  return value;
}

constexpr int kLoads = 5000;

/// Loads many values; the number of torn ones and of those older than one before.
int watch(const SharedSlot<Value>& slot) {
  int wrong = 0;
  std::uint64_t newest = 0;
  Value value;
  for (int loads = 0; loads < kLoads;) {
    if (!slot.load(value)) continue;
    ++loads;
    if (value != all(value[0]) || value[0] < newest) ++wrong;
    newest = value[0];
  }
  return wrong;
}

TEST(SharedSlot, IsEmptyUntilTheFirstStore) {
  SharedSlot<Value> slot;
  Value value = all(7);
  EXPECT_FALSE(slot.load(value));
  EXPECT_EQ(value, all(7));
  slot.store(all(8));
  EXPECT_TRUE(slot.load(value));
  EXPECT_EQ(value, all(8));
  EXPECT_EQ(slot.sequence(), 2U);
}

TEST(SharedSlot, ThreadsNeverSeeATornOrOlderValue) {
  SharedSlot<Value> slot;
  std::vector<std::thread> readers;
  std::atomic<int> wrong{0};
  std::atomic<int> reading{3};
  for (int i = 0; i < 3; ++i)
    readers.emplace_back([&] {
      wrong.fetch_add(watch(slot));
      reading.fetch_sub(1);
    });
  for (std::uint64_t number = 1; reading.load() > 0; ++number) slot.store(all(number));
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(wrong.load(), 0);
}

TEST(SharedSlot, NorDoProcesses) {
  struct Memory {
    SharedSlot<Value> slot;
    std::atomic<int> wrong;
    std::atomic<int> done;
  };
  void* zeroed = ::mmap(nullptr, sizeof(Memory), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(zeroed, MAP_FAILED);
  auto& memory = *static_cast<Memory*>(zeroed);  // zeroed memory is a valid slot
  Child reader([&memory] {
    memory.wrong.store(watch(memory.slot));
    memory.done.store(1);
  });
  for (std::uint64_t number = 1; memory.done.load() == 0; ++number) memory.slot.store(all(number));
  EXPECT_TRUE(reader.join());
  EXPECT_EQ(memory.wrong.load(), 0);
  ::munmap(zeroed, sizeof(Memory));
}

}  // namespace
}  // namespace mrroc::clock
