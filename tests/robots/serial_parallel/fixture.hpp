#pragma once

#include <filesystem>
#include <memory>
#include <random>

#include "config/table.hpp"
#include "robots/serial_parallel/geometry_file.hpp"
#include "robots/serial_parallel/serial_parallel_model.hpp"

namespace mrroc {

inline std::filesystem::path serial_parallel_source(const std::string& name) {
  return std::filesystem::path(MRROC_SOURCE_DIR) / "robots/serial_parallel" / name;
}

inline const RobotModel& machine() {
  static const auto model = load_serial_parallel(serial_parallel_source("serial_parallel.toml")).front();
  return *model;
}

inline const serial_parallel::Geometry& geometry() {
  static const serial_parallel::Geometry geometry = serial_parallel::read_geometry(
      config::Table::load(serial_parallel_source("serial_parallel.toml")).table("geometry"));
  return geometry;
}

inline const serial_parallel::Tripod& tripod() {
  static const serial_parallel::Tripod tripod(geometry());
  return tripod;
}

/// The placement for the legs of a posture.
inline serial_parallel::Placement placement_of(const JointVector& posture) {
  serial_parallel::Placement placement;
  if (!tripod().assemble(posture.head<3>(), placement)) throw std::runtime_error("the legs do not close");
  return placement;
}

/// One value per axis, from a member of AxisParameters.
inline JointVector per_axis(double AxisParameters::*member) {
  const auto& axes = machine().parameters().axes;
  JointVector values(static_cast<Eigen::Index>(axes.size()));
  for (std::size_t i = 0; i < axes.size(); ++i) values[static_cast<Eigen::Index>(i)] = axes[i].*member;
  return values;
}

/// Evenly distributed over the joints within the limits that the tripod can reach within its passive limits.
inline JointVector random_posture(std::mt19937_64& random) {
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  for (;;) {
    JointVector joints(6);
    for (int i = 0; i < 6; ++i) joints[i] = std::uniform_real_distribution<double>(low[i], high[i])(random);
    if (serial_parallel::Kinematics(geometry()).reaches(joints, 0)) return joints;
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
