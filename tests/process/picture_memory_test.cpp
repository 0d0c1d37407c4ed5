#include "process/picture_memory.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "mrroc/errors.hpp"

namespace mrroc::process::picture_memory_test {
namespace {

std::filesystem::path file_of(const PictureMemory& memory) {
  return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(memory.fd());
}

RC_GTEST_PROP(PictureMemoryProperty, EveryReaderGetsTheLastPictureWhole, ()) {
  const int width = *rc::gen::inRange(1, 40);
  const int height = *rc::gen::inRange(1, 40);
  PictureMemory made = PictureMemory::create(width, height);
  PictureMemory writer = PictureMemory::attach(made.fd(), width, height);
  PictureMemory reader = PictureMemory::open(file_of(made), width, height);
  RC_ASSERT(made.bytes() == static_cast<std::size_t>(3 * width * height));
  Tick tick = 0;
  std::vector<std::uint8_t> seen;
  RC_ASSERT(!reader.load(tick, seen));
  for (std::uint64_t number = 1; number <= 3; ++number) {
    const auto pixels =
        *rc::gen::container<std::vector<std::uint8_t>>(made.bytes(), rc::gen::arbitrary<std::uint8_t>());
    const auto taken = *rc::gen::inRange<Tick>(0, 1'000'000'000'000);
    writer.store(taken, pixels);
    RC_ASSERT(reader.sequence() == 2 * number);
    RC_ASSERT(reader.load(tick, seen));
    RC_ASSERT(tick == taken);
    RC_ASSERT(seen == pixels);
  }
}

TEST(PictureMemory, IsNotTakenForOneOfAnotherSize) {
  const PictureMemory made = PictureMemory::create(64, 48);
  EXPECT_THROW(PictureMemory::attach(made.fd(), 48, 48), SystemError);
  EXPECT_THROW(PictureMemory::open(file_of(made), 64, 49), SystemError);
  EXPECT_THROW(PictureMemory::open("/dev/null", 64, 48), SystemError);
  EXPECT_THROW(PictureMemory::open("/proc/self/fd/nothing", 64, 48), SystemError);
}

TEST(PictureMemory, PicturesAreNotTornWhileTheyChange) {
  constexpr int kLoads = 300;
  const PictureMemory made = PictureMemory::create(200, 100);
  PictureMemory reader = PictureMemory::attach(made.fd(), 200, 100);
  std::atomic<bool> done{false};
  std::thread storing([&] {
    PictureMemory writer = PictureMemory::attach(made.fd(), 200, 100);
    std::vector<std::uint8_t> pixels(writer.bytes());
    for (Tick tick = 1; !done; ++tick) {
      std::fill(pixels.begin(), pixels.end(), static_cast<std::uint8_t>(tick));
      writer.store(tick, pixels);
    }
  });
  Tick tick = 0;
  std::vector<std::uint8_t> seen;
  int torn = 0;
  for (int loads = 0; loads < kLoads;) {
    const Tick before = tick;
    if (!reader.load(tick, seen) || tick == before) continue;
    const auto wrong = [&](std::uint8_t pixel) { return pixel != static_cast<std::uint8_t>(tick); };
    if (tick < before || std::any_of(seen.begin(), seen.end(), wrong)) ++torn;
    ++loads;
  }
  done = true;
  storing.join();
  EXPECT_EQ(torn, 0);
}

}  // namespace
}  // namespace mrroc::process::picture_memory_test
