#include "drivers/ur/measurement_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace mrroc::ur {
namespace {

constexpr double kServoPeriod = 0.002;
constexpr double kTrueSpeed = 1;  // rad/s
constexpr int kSettled = 500;     // ticks

std::int64_t ns(double seconds) { return std::llround((1000 + seconds) * 1e9); }

/// A servo that reads the newest package of a controller in each tick, and what it takes for the speed.
struct Reader {
  double controller_period = kServoPeriod;
  double drift = 0;    ///< of the controller's clock
  double jitter = 0;   ///< s, the greatest delay of a package
  double latency = 0;  ///< s, the greatest delay of a tick

  /// The greatest difference to kTrueSpeed, relative, of two consecutive measurements.
  double worst_error() {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit;
    MeasurementClock clock(kServoPeriod);
    double worst = 0, last_position = 0;
    Tick last_tick = 0;
    double next_arrival = 0, newest = -1, arrival = 0, previous = -2;
    int package = 0;
    for (Tick now = 1; now < 20000; ++now) {
      const double time = static_cast<double>(now) * kServoPeriod + latency * unit(random);
      while (next_arrival <= time) {
        newest = package * controller_period;
        arrival = next_arrival;
        ++package;
        const double sent = package * controller_period * (1 + drift);
        next_arrival = std::max(next_arrival, sent + jitter * unit(random));
      }
      if (newest == previous) continue;
      previous = newest;
      const auto measured = clock.take(newest, ns(arrival), now, ns(time));
      EXPECT_LE(measured.tick, now);
      EXPECT_GE(measured.tick, last_tick);
      if (measured.tick == last_tick) continue;
      const double position = kTrueSpeed * (newest - measured.rest * kServoPeriod);
      if (now > kSettled)
        worst =
            std::max(worst, std::abs((position - last_position) /
                                         (static_cast<double>(measured.tick - last_tick) * kServoPeriod) / kTrueSpeed -
                                     1));
      last_position = position;
      last_tick = measured.tick;
    }
    EXPECT_GT(last_tick, 19900u);
    return worst;
  }
};

TEST(MeasurementClock, SpeedsAreThoseOfTheRobot) {
  EXPECT_LT((Reader{}.worst_error()), 1e-3);
  EXPECT_LT((Reader{.jitter = 0.5 * kServoPeriod}.worst_error()), 0.05);
  EXPECT_LT((Reader{.jitter = 2.5 * kServoPeriod, .latency = 0.3 * kServoPeriod}.worst_error()), 0.1);
  EXPECT_LT((Reader{.drift = 1e-4, .jitter = 0.5 * kServoPeriod, .latency = 0.3 * kServoPeriod}.worst_error()), 0.05);
  EXPECT_LT((Reader{.drift = -1e-4, .jitter = 0.5 * kServoPeriod, .latency = 0.3 * kServoPeriod}.worst_error()), 0.05);
  EXPECT_LT((Reader{.controller_period = 0.008, .jitter = kServoPeriod}.worst_error()), 0.05);
}

double place(const MeasurementClock::Measured& measured) { return static_cast<double>(measured.tick) + measured.rest; }

TEST(MeasurementClock, AnotherClockBeginsAtThePresent) {
  MeasurementClock clock(kServoPeriod);
  const auto take = [&clock](double timestamp, Tick now) {
    const double time = static_cast<double>(now) * kServoPeriod;
    return place(clock.take(timestamp, ns(time), now, ns(time)));
  };
  EXPECT_NEAR(take(1000, 5), 5, 1e-6);
  EXPECT_NEAR(take(1000 + 2.5 * kServoPeriod, 8), 7.5, 0.01);
  EXPECT_NEAR(take(1, 20), 20, 1e-6) << "the controller has restarted";
  EXPECT_NEAR(take(500, 30), 30, 1e-6);
  EXPECT_NEAR(take(std::nan(""), 40), 40, 1e-6);
  EXPECT_NEAR(take(3, 50), 50, 1e-6);
}

/// Each tick of this servo takes 5 % too long.
TEST(MeasurementClock, LongTicksMakeSpeedsWrongByTheirLengthOnly) {
  MeasurementClock clock(kServoPeriod);
  double last = 0;
  for (Tick now = 1; now < 5000; ++now) {
    const double time = static_cast<double>(now) * 1.05 * kServoPeriod;
    const double sent = std::floor(time / kServoPeriod) * kServoPeriod;
    const auto measured = clock.take(sent, ns(sent), now, ns(time));
    const double position = sent - measured.rest * kServoPeriod;
    if (now > kSettled) {
      ASSERT_EQ(measured.tick, now);
      ASSERT_NEAR((position - last) / kServoPeriod, 1.05, 0.06) << now;
    }
    last = position;
  }
}

TEST(MeasurementClock, APackageIsNotMeasuredInTheFuture) {
  MeasurementClock clock(kServoPeriod);
  clock.take(0, ns(0), 5, ns(0));
  const auto measured = clock.take(4 * kServoPeriod, ns(4 * kServoPeriod), 6, ns(4 * kServoPeriod));
  EXPECT_EQ(measured.tick, 6u);
  EXPECT_NEAR(measured.rest, 3 - MeasurementClock::kStep, 0.01);
  const auto far = clock.take(100 * kServoPeriod, ns(100 * kServoPeriod), 7, ns(100 * kServoPeriod));
  EXPECT_EQ(far.tick, 7u);
  EXPECT_NEAR(far.rest, MeasurementClock::kLatest + MeasurementClock::kMostAhead, 0.01);
}

}  // namespace
}  // namespace mrroc::ur
