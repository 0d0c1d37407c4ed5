#pragma once

#include "mrroc/types.hpp"
#include "robots/serial_parallel/geometry.hpp"

namespace mrroc::serial_parallel {

/// Placement of the tripod's platform: its remaining degrees of freedom.
struct Placement {
  double swing = 0;   ///< rad, of the plane of legs A and C about the base's y axis
  double tilt = 0;    ///< rad, of the platform in that plane, about the platform's x axis
  double height = 0;  ///< m, of the platform frame's origin above the base's, along the platform's z axis
};

/// Angles of the joints at the base that no motor drives, rad. Each leg first turns about the base's y axis, then about
/// its own x axis, its z axis pointing to the platform. Legs A and C turn about y together: by `Placement::swing`.
struct PassiveAngles {
  double lean_a = 0, lean_b = 0, lean_c = 0;  ///< about x
  double pitch_b = 0;                         ///< of leg B about y
};

/// The parallel part, an Exechon tripod: legs A and C are in universal joints with a common first axis (the base's y
/// axis) and carry the platform in hinges along its x axis; leg B is in a spherical joint and carries the platform
/// in a hinge along its y axis. Tripod frame: z towards the platform, x towards leg B. Kinematics after M. Zoppi, D.
/// Zlatanov, R. Molfino, "Kinematics analysis of the Exechon tripod", DETC2010-28668, with the wrist's centre on the
/// platform's z axis; angles counted from the upright platform.
///
/// Legs A and C let the platform move in one plane that swings about y; the hinge of leg B holds it at right angles to
/// that leg. So with s = base.b sin(swing), R = Ry(swing) Rx(tilt):
///   platform frame   R, R (0, s sin(tilt), height)
///   leg A, C         (platform.l + s sin(tilt) - base.l cos(tilt))^2 + (height + base.l sin(tilt))^2 = length^2
///   leg B            (platform.b - base.b cos(swing))^2 + (height - s cos(tilt))^2 = length^2
///
/// Any thread; never allocates or throws.
class Tripod {
 public:
  explicit Tripod(const Geometry& geometry) noexcept;

  /// Frame of the platform in the tripod frame.
  Pose platform(const Placement& placement) const noexcept;
  /// Lengths of legs A, B, C, m.
  Eigen::Vector3d legs(const Placement& placement) const noexcept;
  /// d legs / d (swing, tilt, height).
  Eigen::Matrix3d leg_rates(const Placement& placement) const noexcept;

  /// The placement whose legs have these lengths, by Newton's method on their squares from the platform level at the
  /// mean height of legs A and C; `kIterations` steps at most. It converges in these to every placement within
  /// the passive limits and up to ten degrees beyond (tests/robots/serial_parallel/tripod_test.cpp checks them).
  /// False when the legs do not close with the platform upright: then `placement` is level, base.b high.
  bool assemble(const Eigen::Vector3d& legs, Placement& placement) const noexcept;
  static constexpr int kIterations = 8;

  /// The placement that has the wrist's centre at `centre`, tripod frame: in closed form.
  Placement placement_of(const Eigen::Vector3d& centre) const noexcept;

  PassiveAngles passive_angles(const Placement& placement) const noexcept;
  /// Whether the platform is upright (both angles below a right one, above the base) and every passive angle is within
  /// its limit, `allowance` rad granted. False when a value is not finite.
  bool within_limits(const Placement& placement, double allowance) const noexcept;

 private:
  /// Squares of the legs' lengths (m^2) and, on request, their derivatives with respect to swing, tilt and height.
  Eigen::Vector3d squared_legs(const Placement& placement, Eigen::Matrix3d* rates = nullptr) const noexcept;

  LegPoints base_;
  LegPoints platform_;
  double platform_to_wrist_;
  PassiveLimits limits_;
};

}  // namespace mrroc::serial_parallel
