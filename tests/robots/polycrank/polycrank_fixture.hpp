#pragma once

#include <cmath>
#include <filesystem>
#include <random>

#include "mrroc/tool_kinematics.hpp"
#include "robots/polycrank/polycrank_model.hpp"

namespace mrroc {

inline std::filesystem::path polycrank_source(const std::string& name) {
  return std::filesystem::path(MRROC_SOURCE_DIR) / "robots/polycrank" / name;
}

inline const RobotModel& polycrank_model() {
  static const RobotModels models = load_polycrank(polycrank_source("polycrank.toml"));
  return *models.front();
}

inline const JointVector& polycrank_home() { return polycrank_model().parameters().home; }

/// One value per axis, from a member of AxisParameters.
inline JointVector per_axis(double AxisParameters::*member) {
  const auto& axes = polycrank_model().parameters().axes;
  JointVector values(static_cast<Eigen::Index>(axes.size()));
  for (std::size_t i = 0; i < axes.size(); ++i) values[static_cast<Eigen::Index>(i)] = axes[i].*member;
  return values;
}

/// Evenly distributed over some turns in either direction.
inline JointVector random_joints(std::mt19937_64& random, double turns = 3) {
  JointVector joints(7);
  for (int i = 0; i < 7; ++i) {
    joints[i] = std::uniform_real_distribution<double>(-2 * M_PI * turns, 2 * M_PI * turns)(random);
  }
  return joints;
}

inline JointVector joints_of(std::initializer_list<double> values) {
  JointVector joints(7);
  std::copy(values.begin(), values.end(), joints.data());
  return joints;
}

/// Largest difference of position (m) and rotation (rad) between two poses.
inline double pose_difference(const Pose& a, const Pose& b) {
  const Eigen::Matrix3d r = a.linear().transpose() * b.linear();
  const Eigen::Vector3d twice_sine(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  const double angle = std::atan2(twice_sine.norm(), r.trace() - 1);
  return std::max((a.translation() - b.translation()).norm(), angle);
}

/// The flange's Jacobian at its own origin.
inline Jacobian flange_jacobian(const JointVector& joints) {
  return polycrank_model().jacobian(joints, Eigen::Vector3d::Zero());
}

}  // namespace mrroc
