#include "core/lockfree/shared_slot.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <atomic>
#include <thread>
#include <vector>

#include "clock/child.hpp"
#include "clock/toy_network.hpp"

namespace mrroc::clock {
namespace {

// large, so that loads and stores are mostly interrupted half way
using Value = std::array<std::uint64_t, 1000>;

Value all(std::uint64_t number) {
  Value value;
  value.fill(number);
  return value;
}

/// Loads values until `done`; returns the number of torn values and of values older than one before.
int watch(const core::SharedSlot<Value>& slot, const std::atomic<int>& done) {
  int wrong = 0;
  std::uint64_t newest = 0;
  Value value;
  while (done.load() == 0) {
    if (!slot.load(value)) continue;
    if (value != all(value[0]) || value[0] < newest) ++wrong;
    newest = value[0];
  }
  return wrong;
}

struct Memory {
  core::SharedSlot<Value> slot;
  std::atomic<int> done;
  std::atomic<int> wrong;
};

class SharedSlotOfProcesses : public ::testing::Test {
 protected:
  ~SharedSlotOfProcesses() override { ::munmap(&memory_, sizeof(Memory)); }
  // zeroed memory is a valid slot
  Memory& memory_ =
      *static_cast<Memory*>(::mmap(nullptr, sizeof(Memory), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
};

TEST(SharedSlot, IsEmptyUntilTheFirstStore) {
  core::SharedSlot<Value> slot;
  Value value = all(7);
  EXPECT_FALSE(slot.load(value));
  EXPECT_EQ(value, all(7));
  slot.store(all(8));
  EXPECT_TRUE(slot.load(value));
  EXPECT_EQ(value, all(8));
  EXPECT_EQ(slot.sequence(), 2U);
}

TEST(SharedSlot, ThreadsNeverLoadATornOrOlderValue) {
  core::SharedSlot<Value> slot;
  std::vector<std::thread> readers;
  std::atomic<int> wrong{0};
  std::atomic<int> done{0};
  for (int i = 0; i < 3; ++i) readers.emplace_back([&] { wrong.fetch_add(watch(slot, done)); });
  for (std::uint64_t number = 1; number <= 20000; ++number) slot.store(all(number));
  done.store(1);
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(wrong.load(), 0);
}

TEST_F(SharedSlotOfProcesses, InterruptedReaderReadsAgain) {
  Child reader([this] { memory_.wrong.store(watch(memory_.slot, memory_.done)); });
  for (std::uint64_t number = 1; number <= 200; ++number) {
    stray(200);
    reader.stop();
    memory_.slot.store(all(number));
    reader.go_on();
  }
  memory_.done.store(1);
  EXPECT_TRUE(reader.join());
  EXPECT_EQ(memory_.wrong.load(), 0);
}

TEST_F(SharedSlotOfProcesses, LoadsNothingWhileAWriterIsStopped) {
  Child writer([this] {
    for (std::uint64_t number = 1;; ++number) memory_.slot.store(all(number));
  });
  while (memory_.slot.sequence() == 0) {
  }
  for (int i = 0; i < 50; ++i) {
    stray(200);
    writer.stop();
    Value value;
    const bool loaded = memory_.slot.load(value);
    EXPECT_EQ(loaded, memory_.slot.sequence() % 2 == 0);
    EXPECT_TRUE(!loaded || value == all(memory_.slot.sequence() / 2));
    writer.go_on();
  }
}

}  // namespace
}  // namespace mrroc::clock
