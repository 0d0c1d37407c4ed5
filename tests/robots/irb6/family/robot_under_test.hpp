#pragma once

#include <filesystem>
#include <random>
#include <string>

#include "mrroc/tool_kinematics.hpp"

namespace mrroc {

/// The robot of the family that a test executable tests.
struct RobotUnderTest {
  std::string name;
  RobotModels models;
};

/// Defined once in every test executable.
const RobotUnderTest& robot_under_test();

/// Its default model, alone and with the default tool.
inline const RobotModel& robot() { return *robot_under_test().models.front(); }
inline ToolKinematics arm() { return ToolKinematics(robot()); }

/// robots/<name>/<name>.<extension> of the source tree.
inline std::filesystem::path robot_file(const std::string& name, const std::string& extension) {
  return std::filesystem::path(MRROC_SOURCE_DIR) / "robots" / name / (name + "." + extension);
}
inline std::filesystem::path robot_file(const std::string& extension) {
  return robot_file(robot_under_test().name, extension);
}

/// One value per axis, from a member of AxisParameters.
inline JointVector per_axis(double AxisParameters::*member) {
  const auto& axes = robot().parameters().axes;
  JointVector values(static_cast<Eigen::Index>(axes.size()));
  for (std::size_t i = 0; i < axes.size(); ++i) values[static_cast<Eigen::Index>(i)] = axes[i].*member;
  return values;
}

/// Evenly distributed within the joint limits, ignoring the transmission.
inline JointVector random_joints(std::mt19937_64& random) {
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  JointVector joints(robot().joint_count());
  for (int i = 0; i < joints.size(); ++i) joints[i] = std::uniform_real_distribution<double>(low[i], high[i])(random);
  return joints;
}

/// Whether the robot can reach these joints: only the motor limits are checked.
inline bool within_motor_limits(const JointVector& joints) {
  JointVector motors;
  if (robot().joints_to_motors(joints, motors) != ErrorCode::none) return false;
  return (motors.array() >= per_axis(&AxisParameters::motor_min).array()).all() &&
         (motors.array() <= per_axis(&AxisParameters::motor_max).array()).all();
}

/// Within joint and motor limits.
inline JointVector random_posture(std::mt19937_64& random) {
  for (;;) {
    const JointVector joints = random_joints(random);
    if (within_motor_limits(joints)) return joints;
  }
}

/// Largest difference of position (m) and rotation (rad) between two poses.
inline double pose_difference(const Pose& a, const Pose& b) {
  const Eigen::Matrix3d r = a.linear().transpose() * b.linear();
  const Eigen::Vector3d twice_sine(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  const double angle = std::atan2(twice_sine.norm(), r.trace() - 1);
  return std::max((a.translation() - b.translation()).norm(), angle);
}

}  // namespace mrroc
