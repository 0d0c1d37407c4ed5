#pragma once

#include <mrroc/generators/cooperative_motion.hpp>
#include <vector>

/// The path of the bar in the world: m, rad. Its frame is in its middle, y along it, z up.
namespace mrroc::transfer {

inline Pose bar_at(double x, double y, double z, double roll = 0, double pitch = 0, double yaw = 0) {
  return Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
}

inline constexpr double kGrip = 0.28;  // m, from the middle to either gripper

/// The arms that carry it.
struct Arms {
  double grip;         ///< m, from the wrist's sensor to the grip, along the tool
  double tool_centre;  ///< m, from there to the centre of the mass beyond it
  bool tilt;           ///< whether their tools reach any orientation; else they always point down
};
inline constexpr Arms kSixAxes{0.285, 0.1361, true}, kFiveAxes{0.289, 0.138, false};

namespace way {
inline std::vector<Pose> lift() { return {bar_at(0.75, 0, 0.50), bar_at(0.75, 0, 0.60)}; }
inline std::vector<Pose> carry(const Arms& arms = kSixAxes) {
  const double tilt = arms.tilt ? 1 : 0;
  return {lift().back(), bar_at(0.78, -0.10, 0.75, 0.15 * tilt, 0.10 * tilt, 0.25),
          bar_at(0.88, 0.10, 0.78, -0.15 * tilt, -0.20 * tilt, -0.10), bar_at(0.93, -0.06, 0.64, 0, 0, -0.20)};
}
inline std::vector<Pose> lower() { return {carry().back(), bar_at(0.93, -0.06, 0.55, 0, 0, -0.20)}; }
inline std::vector<Pose> put_down() {
  return {lower().back(), bar_at(0.93, -0.06, 0.535, 0, 0, -0.20)};
}  // it lies at 0.545
}  // namespace way

inline constexpr CooperativeLimits kFree{
    .speed = 0.07, .acceleration = 0.13, .angular_speed = 0.13, .angular_acceleration = 0.26};
inline constexpr CooperativeLimits kNear{
    .speed = 0.03, .acceleration = 0.06, .angular_speed = 0.05, .angular_acceleration = 0.1};
inline constexpr CooperativeLimits kTouch{
    .speed = 0.005, .acceleration = 0.02, .angular_speed = 0.05, .angular_acceleration = 0.1};

}  // namespace mrroc::transfer
