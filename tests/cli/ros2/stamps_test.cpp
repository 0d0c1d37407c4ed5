#include "cli/ros2/stamps.hpp"

#include <gtest/gtest.h>

#include <random>

namespace mrroc::cli::stamps_test {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kStart = 1'800'000'000 * kSecond;

std::int64_t ns(const messages::builtin_interfaces::Time& time) { return time.sec * kSecond + time.nanosec; }

TEST(Stamps, OfASimulatedClockAreItsOwnTime) {
  Stamps stamps(true, 0.002);
  EXPECT_EQ(ns(stamps.of(0, kStart)), 0);
  EXPECT_EQ(ns(stamps.of(1501, kStart)), 3'002'000'000);
  EXPECT_EQ(ns(stamps.at(kStart)), 3'002'000'000);
}

TEST(Stamps, OfTheRealClockAreTheSystemsTimeAtThatTick) {
  std::mt19937_64 random(7);
  Stamps stamps(false, 0.002);
  std::int64_t worst = 0;
  for (Tick tick = 0; tick < 50000; tick += 10) {
    // states arrive between 0 and 20 ms late
    const auto late = static_cast<std::int64_t>(random() % 20'000'000);
    const std::int64_t true_time = kStart + static_cast<std::int64_t>(tick) * 2'000'000;
    const std::int64_t error = ns(stamps.of(tick, true_time + late)) - true_time;
    EXPECT_GE(error, 0);
    if (tick > 5000) worst = std::max(worst, error);
  }
  EXPECT_LT(worst, 1'000'000);
}

TEST(Stamps, FollowASystemClockThatDrifts) {
  Stamps stamps(false, 0.002);
  std::int64_t error = 0;
  for (Tick tick = 0; tick < 5'000'000; tick += 10) {
    const std::int64_t own = static_cast<std::int64_t>(tick) * 2'000'000;
    const std::int64_t system = kStart + own + own / 10000;  // 100 ppm
    error = ns(stamps.of(tick, system)) - system;
  }
  EXPECT_LT(std::abs(error), 1'000'000) << "after 10 000 s the clocks are 1 s apart";
}

}  // namespace
}  // namespace mrroc::cli::stamps_test
