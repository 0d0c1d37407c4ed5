#pragma once

#include <optional>

namespace mrroc::two_finger_gripper {

/// `[geometry]` of two_finger_gripper.toml: the transmission's parabola and the fingers' length.
struct Geometry {
  double opening_at_zero = 0;    ///< m
  double opening_slope = 0;      ///< m/rad
  double opening_curvature = 0;  ///< m/rad^2, not 0
  double reach = 0;              ///< from the mounting face to the middle of the pads, m
};

/// Motor position at which the opening is extreme and the transmission has a dead centre, rad.
inline double dead_centre(const Geometry& geometry) {
  return -geometry.opening_slope / (2 * geometry.opening_curvature);
}

/// Motor (rad) <-> opening between the pads (m). About the dead centre (m0, j0) the original's parabola is
///
///     j = j0 + k (m - m0)^2,     m = m0 +- sqrt((j - j0) / k),     dm/dj = 1 / (2 k (m - m0)),
///
/// with the sign of the side on which the motor works. Any thread; never allocates or throws.
class Transmission {
 public:
  /// The motor works on the side of the dead centre on which `motor` is.
  Transmission(const Geometry& geometry, double motor) noexcept;

  /// m; nothing at the dead centre, beyond it, or when `motor` is not finite.
  std::optional<double> opening(double motor) const noexcept;
  /// rad; nothing when no motor position gives `opening`.
  std::optional<double> motor(double opening) const noexcept;
  /// dm/dj, rad/m; finite: nearer than 1 rad to the dead centre, and without a motor position, the value at 1 rad.
  double ratio(double opening) const noexcept;

 private:
  double dead_motor_, dead_opening_, curvature_;
  double side_;  ///< +1 or -1
};

}  // namespace mrroc::two_finger_gripper
