#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/ur/rtde/messages.hpp"
#include "mrroc/types.hpp"

namespace mrroc::ur {

/// The point about which a controller reports the torques of actual_TCP_force.
enum class TorquePoint {
  flange,  ///< e-Series, whose sensor is in the flange
  tool     ///< CB3, which estimates the wrench from the currents of its joints: the tool centre point
};

/// The fields of a package that the wrench needs.
struct WrenchPackage {
  double timestamp = 0;            ///< s, of the controller
  Wrench force = Wrench::Zero();   ///< actual_TCP_force: N, N m, in the axes of the base frame
  Pose tool = Pose::Identity();    ///< actual_TCP_pose, in the base frame
  Pose offset = Pose::Identity();  ///< tcp_offset: the tool in the flange frame
};

/// Their names for the recipe. tcp_offset needs PolyScope 3.12 or 5.5.1.
std::vector<std::string> wrench_fields();
/// Nothing: a value has another type.
std::optional<WrenchPackage> read_wrench(const std::vector<rtde::Value>& values) noexcept;

/// The matrix of a rotation by a (rad), given as a vector of length a along its axis: the form of the controller.
Eigen::Matrix3d rotation_of(const Eigen::Vector3d& rotation_vector) noexcept;

/// The load on a sensor: the wrench that the environment exerts on the tool, without the weight of the payload, in the
/// axes of the sensor frame and about its origin (N, N m). `mount` is the sensor frame in the flange frame. With F, T
/// the reported force and torque, R_t the tool's orientation in the base frame, (R_o, o) the tool in the flange frame,
/// (R_m, m) the mount:
///
///     R = R_t R_o^T          orientation of the flange in the base frame
///     f = R^T F              t = R^T T  about the flange, or R^T T + o x f about the tool
///     load = (R_m^T f, R_m^T (t - m x f))
///
/// Sources: RTDE guide (outputs), URScript manual (get_tcp_force), which give the axes; the drivers of Universal Robots
/// for ROS, which distinguish the points. A reported force is positive where the environment pushes the tool along the
/// axis.
Wrench load_on_sensor(const WrenchPackage& package, TorquePoint point, const Pose& mount) noexcept;

}  // namespace mrroc::ur
