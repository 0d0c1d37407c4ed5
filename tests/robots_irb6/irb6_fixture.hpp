#pragma once

#include <filesystem>
#include <memory>
#include <random>

#include "config/table.hpp"
#include "mrroc/tool_kinematics.hpp"
#include "robots/irb6/geometry_file.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc {

inline std::filesystem::path irb6_source(const std::string& name) {
  return std::filesystem::path(MRROC_SOURCE_DIR) / "robots/irb6" / name;
}

inline const RobotModel& irb6_model() {
  static const RobotModels models = load_irb6(irb6_source("irb6.toml"));
  return *models.front();
}

/// The same with the default tool.
inline ToolKinematics irb6_kinematics() { return ToolKinematics(irb6_model()); }

inline irb6::Geometry irb6_geometry() {
  return irb6::read_geometry(config::Table::load(irb6_source("irb6.toml")).table("geometry"));
}

/// One value per axis, from a member of AxisParameters.
inline JointVector per_axis(double AxisParameters::*member) {
  const auto& axes = irb6_model().parameters().axes;
  JointVector values(static_cast<Eigen::Index>(axes.size()));
  for (std::size_t i = 0; i < axes.size(); ++i) values[static_cast<Eigen::Index>(i)] = axes[i].*member;
  return values;
}

/// Evenly distributed within the joint limits, without regard to the transmission.
inline JointVector random_joints(std::mt19937_64& random) {
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  JointVector joints(6);
  for (int i = 0; i < 6; ++i) joints[i] = std::uniform_real_distribution<double>(low[i], high[i])(random);
  return joints;
}

/// Whether the robot can stand there: joint limits are taken as given, motor limits are looked at.
inline bool within_motor_limits(const JointVector& joints) {
  JointVector motors;
  if (irb6_model().joints_to_motors(joints, motors) != ErrorCode::none) return false;
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
