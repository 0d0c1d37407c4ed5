#include "vsp/raw_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mrroc/errors.hpp"
#include "vsp/noise.hpp"

namespace mrroc::vsp::raw_watch_test {
namespace {

constexpr double kPeriod = 0.002;

class RawWatchTest : public ::testing::Test {
 protected:
  RawWatch watch(double frozen_after, std::vector<double> noise_max) {
    config::SensorEntry entry;
    entry.name = "gate";
    entry.frozen_after = frozen_after;
    entry.noise_max = std::move(noise_max);
    return {entry, {{"range", "m"}, {"level", "V"}}, kPeriod};
  }
  /// The error of the reading of `tick`.
  static std::string check(RawWatch& watch, Tick tick, double range, double level = 0) {
    RawReading r;
    r.tick = tick;
    r.count = 2;
    r.values = {range, level};
    SensorReading v;
    watch.check(r, v);
    EXPECT_TRUE(v.error.error_class == ErrorClass::none || v.error.code == ErrorCode::sensor_hardware);
    return std::string(v.error.detail.view());
  }
};

TEST_F(RawWatchTest, FindsNothingWithoutLimits) {
  RawWatch watch = RawWatchTest::watch(0, {});
  for (Tick k = 0; k < 5000; ++k) EXPECT_EQ(check(watch, k, k % 2 == 0 ? 0 : 1e6), "");
  for (Tick k = 5000; k < 10000; ++k) EXPECT_EQ(check(watch, k, 1), "");
}

TEST_F(RawWatchTest, FrozenMeansUnchangedForTooLong) {
  RawWatch watch = RawWatchTest::watch(0.1, {});  // 50 ticks
  for (Tick k = 0; k <= 30; ++k) EXPECT_EQ(check(watch, k, 0.5), "");
  EXPECT_EQ(check(watch, 31, std::nextafter(0.5, 1)), "") << "a change of one bit is sufficient";
  for (Tick k = 32; k < 81; ++k) EXPECT_EQ(check(watch, k, std::nextafter(0.5, 1)), "");
  EXPECT_EQ(check(watch, 81, std::nextafter(0.5, 1)), "frozen: range has been 0.5 for 50 ticks");
  EXPECT_EQ(check(watch, 82, std::nextafter(0.5, 1), 1), "") << "the other value has changed";
}

TEST_F(RawWatchTest, TwoReadingsFarApartAreNotFrozen) {
  RawWatch watch = RawWatchTest::watch(0.1, {});
  EXPECT_EQ(check(watch, 0, 1), "");
  EXPECT_EQ(check(watch, 1000, 1), "");
  EXPECT_NE(check(watch, 1001, 1), "");
}

TEST_F(RawWatchTest, NoiseIsComputedFromTheSignalsSecondDifferences) {
  const Noise noise{"gate"};
  const auto first_found = [&](double deviation, double limit) {
    RawWatch watch = RawWatchTest::watch(0, {limit, 0});
    for (Tick k = 0; k < 2000; ++k) {
      const double t = kPeriod * static_cast<double>(k);
      const double motion = 2 * t + 0.3 * std::sin(6 * t);  // the measured object moves at metres per second
      if (!check(watch, k, motion + deviation * noise.normal(k, 0), 100 * noise.normal(k, 1)).empty()) return k;
    }
    return kNever;
  };
  EXPECT_EQ(first_found(0, 1e-4), kNever) << "motion is not noise";
  EXPECT_EQ(first_found(0.01, 0.02), kNever);
  EXPECT_EQ(first_found(0.03, 0.02), RawWatch::kWindow + 1) << "as soon as the window is full";
}

TEST_F(RawWatchTest, HasOneLimitPerRawChannel) { EXPECT_THROW(watch(0, {1, 2, 3}), SystemError); }

}  // namespace
}  // namespace mrroc::vsp::raw_watch_test
