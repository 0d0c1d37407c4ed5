#pragma once

#include <optional>

#include "mrroc/errors.hpp"
#include "mrroc/types.hpp"
#include "robots/irb6/geometry.hpp"

namespace mrroc::irb6 {

/// Motor <-> arm angle through a ball screw: m(t) = gear (length(t) - synchro_length) + zero. The arm moves between
/// the two dead centres of the linkage, where dm/dt = 0; outside them an angle has no unique motor position.
class Screw {
 public:
  /// `zero`: motor position at synchro_length, rad.
  Screw(const ScrewGeometry& geometry, double zero) noexcept;

  /// Between the dead centres, within (-pi, pi].
  bool reaches(double angle) const noexcept;
  double motor(double angle) const noexcept;
  /// dm/dt, rad/rad.
  double ratio(double angle) const noexcept;
  /// Nothing when no triangle has that screw length.
  std::optional<double> angle(double motor) const noexcept;

 private:
  double length(double angle) const noexcept;

  ScrewGeometry geometry_;
  double zero_;
};

/// Motors (rad at the shaft) <-> joints (rad). Motors 2, 3 and 4 drive the absolute angles of the arms through the
/// parallelogram and the rods: t2 = q2, t3 = q2 + q3 + pi/2, t4 = t3 + q4. The wrist roll turns along with motor 4:
/// m5 = gear q5 + zero + (m4 - zero of motor 4). Without tool roll it is that of the arm with five axes. Any thread;
/// never allocates or throws.
class Transmission {
 public:
  explicit Transmission(const Geometry& geometry) noexcept;

  /// `none`, or `motor_limit` when no joints belong to `motors` (then `joints` is unchanged).
  ErrorCode motors_to_joints(const JointVector& motors, JointVector& joints) const noexcept;
  /// `none`, or `joint_limit` when a screw is past its dead centre or a value is not finite (`motors` unchanged).
  ErrorCode joints_to_motors(const JointVector& joints, JointVector& motors) const noexcept;
  /// G(q) = d motors / d joints.
  JointMatrix matrix(const JointVector& joints) const noexcept;

 private:
  bool has_tool_roll() const noexcept { return zero_.size() == 6; }

  Screw lower_arm_;
  Screw upper_arm_;
  double column_gear_;
  double wrist_pitch_gear_;
  double wrist_roll_gear_;
  double tool_roll_gear_;
  JointVector zero_;
};

}  // namespace mrroc::irb6
