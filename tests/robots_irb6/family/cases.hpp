#pragma once

#include <rapidcheck.h>

#include "robots_irb6/family/robot_under_test.hpp"

namespace mrroc {

/// Evenly distributed over [low, high]; part of the rapidcheck case, so that a failure shrinks and replays.
inline double any_between(double low, double high) {
  constexpr int kSteps = 1 << 30;
  return low + (high - low) * *rc::gen::inRange(0, kSteps) / (kSteps - 1);
}

/// Within joint and motor limits.
inline JointVector any_posture() {
  std::mt19937_64 random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 30)));
  return random_posture(random);
}

/// One of the robot's models.
inline const RobotModel& any_model() {
  const RobotModels& models = robot_under_test().models;
  return *models[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(models.size())))];
}

/// Numbers of every size, infinities and NaN among them.
inline double any_garbage() {
  const double mantissa = any_between(-10, 10);
  switch (*rc::gen::inRange(0, 12)) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return std::numeric_limits<double>::infinity();
    case 2:
      return -std::numeric_limits<double>::infinity();
    case 3:
      return 0;
    case 4:
    case 5:
      return std::ldexp(mantissa, *rc::gen::inRange(-1060, 1020));
    default:
      return mantissa;
  }
}

inline JointVector any_garbage_joints() {
  JointVector joints(robot().joint_count());
  for (int i = 0; i < joints.size(); ++i) joints[i] = any_garbage();
  return joints;
}

}  // namespace mrroc
