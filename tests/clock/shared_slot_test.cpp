#include "clock/shared_slot.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <atomic>
#include <thread>
#include <vector>

#include "clock/child.hpp"

namespace mrroc::clock {
namespace {

using Value = std::array<std::uint64_t, 40>;

Value all(std::uint64_t number) {
  Value value;
  value.fill(number);
  return value;
}

/// Loads until the last value has come; the number of torn or older ones.
int watch(const SharedSlot<Value>& slot, std::uint64_t last) {
  int wrong = 0;
  std::uint64_t newest = 0;
  Value value;
  while (newest < last) {
    if (!slot.load(value)) continue;
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
  constexpr std::uint64_t kStores = 20000;
  SharedSlot<Value> slot;
  std::vector<std::thread> readers;
  std::atomic<int> wrong{0};
  for (int i = 0; i < 3; ++i) readers.emplace_back([&] { wrong.fetch_add(watch(slot, kStores)); });
  for (std::uint64_t number = 1; number <= kStores; ++number) slot.store(all(number));
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(wrong.load(), 0);
}

TEST(SharedSlot, NorDoProcesses) {
  constexpr std::uint64_t kStores = 20000;
  void* memory = ::mmap(nullptr, sizeof(SharedSlot<Value>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  auto& slot = *static_cast<SharedSlot<Value>*>(memory);  // zeroed memory is a valid slot
  Child reader([&slot] {
    if (watch(slot, kStores) != 0) ::_exit(1);
  });
  for (std::uint64_t number = 1; number <= kStores; ++number) slot.store(all(number));
  EXPECT_TRUE(reader.join());
  ::munmap(memory, sizeof(SharedSlot<Value>));
}

}  // namespace
}  // namespace mrroc::clock
