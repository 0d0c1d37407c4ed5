#include "language/paths/path_timing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mrroc::path_timing_test {
namespace {

/// A joint's path s + waves of s, which counts the evaluations of its derivatives.
class CountingPath : public RobotPath {
 public:
  CountingPath(double length, double speed, double waves) : waves_(waves) {
    breaks_ = stops_ = waypoints_ = {0, length};
    limits_ = {{kJointRow, 1, speed, 5 * speed * speed, 50 * speed * speed * speed}};
  }
  PathRates rates(std::size_t, double s) const noexcept override {
    ++asked;
    PathRates rates;
    rates.first[kJointRow] = 1 + waves_ * std::cos(10 * s);
    rates.second[kJointRow] = -10 * waves_ * std::sin(10 * s);
    rates.third[kJointRow] = -100 * waves_ * std::cos(10 * s);
    return rates;
  }
  JointVector joints(double) const noexcept override { return JointVector::Zero(1); }
  void command(double, double, double, RobotCommand&) const noexcept override {}
  mutable std::uint64_t asked = 0;

 private:
  double waves_;
};

TEST(PathTiming, NumberOfChecksDoesNotGrowWithTheDuration) {
  for (const double waves : {0.0, 0.2, 0.8}) {
    const CountingPath fast(1, 1, waves);
    const double least = PathTiming(fast, 0, 1, 0.02).duration();
    for (const double speed : {0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8}) {
      const CountingPath slow(1, speed, waves);
      const PathTiming timing(slow, 0, 1, 0.02);
      EXPECT_NEAR(timing.duration() * speed / least, 1, 0.05) << speed;
      EXPECT_LT(slow.asked, 150000u) << speed;
      EXPECT_NEAR(timing.at(timing.duration()).position, 1, 1e-9);
    }
  }
}

TEST(PathTiming, KeepsTheLimitsBetweenItsChecks) {
  for (const double waves : {0.0, 0.2, 0.8}) {
    for (const double speed : {1.0, 1e-2, 1e-4}) {
      const CountingPath path(1, speed, waves);
      const PathTiming timing(path, 0, 1, 0.02);
      double worst = 0;
      for (int k = 0; k <= 100000; ++k) {
        const PathTiming::Point point = timing.at(timing.duration() * k / 100000);
        worst = std::max(worst, excess_of(path, point.position, point.speed, point.acceleration, point.jerk).factor);
      }
      EXPECT_LE(worst, 1.01) << speed << ' ' << waves;
    }
  }
}

}  // namespace
}  // namespace mrroc::path_timing_test
