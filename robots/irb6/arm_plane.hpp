#pragma once

#include <optional>

#include "mrroc/robot_parameters.hpp"
#include "mrroc/types.hpp"
#include "robots/irb6/geometry.hpp"

namespace mrroc::irb6 {

/// Unit vectors, in the base frame, of a frame that is turned by `column` about z and then pitched down by `pitch`.
struct ArmAxes {
  ArmAxes(double column, double pitch) noexcept;
  Eigen::Vector3d along;   ///< forward and down
  Eigen::Vector3d side;    ///< level, to the left: the direction of the axes of lower arm, upper arm and wrist pitch
  Eigen::Vector3d normal;  ///< up and forward
};

/// Absolute angles of the links in the arm's vertical plane, rad: 0 forward, pi/2 down.
struct ArmAngles {
  /// Of an arm's joints (column first): q2, q2 + q3 + pi/2, q2 + q3 + pi/2 + q4.
  explicit ArmAngles(const JointVector& joints) noexcept;
  double lower_arm;
  double upper_arm;
  double wrist;
};

/// The common part of all arms of the family: lower arm, upper arm and wrist move in the vertical plane of the column.
/// The base frame is at the shoulder, z up, x forward at q1 = 0. Any thread; never allocates or throws.
class ArmPlane {
 public:
  explicit ArmPlane(const Geometry& geometry) noexcept;

  /// Positions in the base frame, m.
  Eigen::Vector3d elbow(double column, const ArmAngles& angles) const noexcept;
  Eigen::Vector3d wrist_pitch(double column, const ArmAngles& angles) const noexcept;
  /// End of the wrist: with r = lower_arm cos t2 + upper_arm cos t3 + wrist cos t4 it is at (r cos q1, r sin q1,
  /// -lower_arm sin t2 - upper_arm sin t3 - wrist sin t4).
  Eigen::Vector3d end(double column, const ArmAngles& angles) const noexcept;

  /// Joints 2, 3, 4 that bring the wrist's end `forward` and `up` (m) with the wrist at absolute angle `wrist`, elbow
  /// up (t3 > t2): the other branch is beyond the screws. q2 is within (-pi, pi]. Nothing when it is out of reach.
  std::optional<Eigen::Vector3d> joints(double forward, double up, double wrist) const noexcept;

  /// How far (m) the end may be behind the column at most, with joints 2 and 3 within their limits: a bound, not less
  /// than 0. `column`: number of the arm's first axis.
  double behind(const RobotParameters& parameters, int column) const noexcept;

 private:
  double lower_arm_;
  double upper_arm_;
  double wrist_;
};

}  // namespace mrroc::irb6
