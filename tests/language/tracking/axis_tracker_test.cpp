// One axis on its way to a target.
#include "language/tracking/axis_tracker.hpp"

#include <cmath>
#include <ruckig/ruckig.hpp>

#include "language/property.hpp"
#include "language/random_values.hpp"

namespace mrroc::fakes::axis_tracker_test {
namespace {

constexpr double kStep = 0.02;

AxisBounds random_bounds() {
  const double velocity = std::pow(10.0, number(-1.3, 0.6)), acceleration = velocity * number(1, 6);
  return {velocity, acceleration, acceleration * number(3, 15)};
}

double shortest(const AxisMotion& from, const AxisBounds& bounds) {
  ruckig::Ruckig<1> ruckig;
  ruckig::InputParameter<1> input;
  ruckig::Trajectory<1> trajectory;
  input.current_position[0] = from.position;
  input.current_velocity[0] = from.velocity;
  input.current_acceleration[0] = from.acceleration;
  input.target_position[0] = input.target_velocity[0] = input.target_acceleration[0] = 0;
  input.max_velocity[0] = bounds.velocity;
  input.max_acceleration[0] = bounds.acceleration;
  input.max_jerk[0] = bounds.jerk;
  ruckig.calculate(input, trajectory);
  return trajectory.get_duration();
}

bool at_target(const AxisMotion& motion) {
  return std::abs(motion.position) < 1e-9 && std::abs(motion.velocity) < 1e-8 && std::abs(motion.acceleration) < 1e-6;
}

void expect_within(const AxisMotion& from, double jerk, const AxisBounds& bounds) {
  RC_ASSERT(std::abs(jerk) <= bounds.jerk * (1 + 1e-6));
  for (int i = 1; i <= 10; ++i) {
    const double t = kStep * i / 10;
    RC_ASSERT(std::abs(from.velocity + t * (from.acceleration + t * jerk / 2)) <= bounds.velocity * (1 + 1e-6));
    RC_ASSERT(std::abs(from.acceleration + t * jerk) <= bounds.acceleration * (1 + 1e-6));
  }
}

/// A step of the target: at most 1.2 of the shortest time and two periods, exactly there, never past it.
TEST(AxisTracker, StepTakesHardlyLongerThanTheShortestTime) {
  const AxisTracker tracker(kStep);
  double worst = 0;
  check_property(2000, [&] {
    const AxisBounds bounds = random_bounds();
    const double way = bounds.velocity * std::pow(10.0, number(-2, 0.7));
    AxisMotion motion{-way, 0, 0};
    const double least = shortest(motion, bounds);
    int periods = 0;
    for (; !at_target(motion); ++periods) {
      RC_ASSERT(periods * kStep <= 1.2 * least + 2 * kStep);
      const double jerk = tracker.jerk(motion, bounds);
      expect_within(motion, jerk, bounds);
      motion = tracker.after(motion, jerk);
      RC_ASSERT(motion.position <= 1e-9 * (1 + way));
    }
    if (least > 0.4) worst = std::max(worst, periods * kStep / least);
  });
  std::cout << "longest against the shortest time, of steps above 0.4 s: " << worst << "\n";
}

TEST(AxisTracker, KeepsItsBoundsWhileTheTargetJumpsAndArrives) {
  const AxisTracker tracker(kStep);
  check_property(1000, [&] {
    const AxisBounds bounds = random_bounds();
    AxisMotion motion;
    for (int i = 0; i < 120; ++i) {
      if (number(0, 1) < 0.1) motion.position += number(-1, 1) * bounds.velocity;
      const double jerk = tracker.jerk(motion, bounds);
      expect_within(motion, jerk, bounds);
      motion = tracker.after(motion, jerk);
    }
    const double least = shortest(motion, bounds);
    int periods = 0;
    for (; !at_target(motion); ++periods) {
      RC_ASSERT(periods * kStep <= 1.5 * least + 8 * kStep);
      const double jerk = tracker.jerk(motion, bounds);
      expect_within(motion, jerk, bounds);
      motion = tracker.after(motion, jerk);
    }
  });
}

TEST(AxisTracker, StaysAtTheTarget) {
  const AxisTracker tracker(kStep);
  EXPECT_EQ(tracker.jerk({}, {1, 2, 20}), 0);
}

}  // namespace
}  // namespace mrroc::fakes::axis_tracker_test
