#pragma once

#include <random>

#include "robots/common/any_number.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {

/// Within joint and motor limits.
inline JointVector any_posture() {
  std::mt19937_64 random(static_cast<std::uint64_t>(any_step()));
  return random_posture(random);
}

/// One of the robot's models.
inline const RobotModel& any_model() {
  const RobotModels& models = robot_under_test().models;
  return *models[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(models.size())))];
}

}  // namespace mrroc
