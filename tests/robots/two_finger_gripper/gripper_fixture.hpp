#pragma once

#include <filesystem>

#include "robots/two_finger_gripper/two_finger_gripper_model.hpp"

namespace mrroc {

inline std::filesystem::path gripper_source(const std::string& name) {
  return std::filesystem::path(MRROC_SOURCE_DIR) / "robots/two_finger_gripper" / name;
}

inline std::shared_ptr<const RobotModel> gripper_model() {
  static const RobotModels models = load_two_finger_gripper(gripper_source("two_finger_gripper.toml"));
  return models.front();
}

inline const AxisParameters& opening_axis() { return gripper_model()->parameters().axes.front(); }

inline JointVector one(double value) { return JointVector::Constant(1, value); }

/// Motor position of an opening that the transmission reaches; NaN otherwise.
inline double motor_of(double opening) {
  JointVector motors;
  const bool reached = gripper_model()->joints_to_motors(one(opening), motors) == ErrorCode::none;
  return reached ? motors[0] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mrroc
