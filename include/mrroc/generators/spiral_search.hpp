#pragma once

#include "mrroc/force_law.hpp"
#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Searches for a hole: while the tool follows a force law (as in ForceControl), it moves in its own x-y plane along an
/// Archimedean spiral around its start position, at a constant speed,
///
///   (x, y) = r (cos phi, sin phi),  r = pitch phi / (2 pi),  dphi/dt = speed / sqrt(r^2 + (pitch / (2 pi))^2),
///
/// commanded as the velocity from macrostep to macrostep. The law should press along z and leave x and y unguarded.
/// Every point within `radius` is at most half the pitch from the spiral: for a peg in a hole choose a pitch below the
/// clearance of the diameters.
///
/// Ends on its own when r has reached `radius`: nothing has been found. The condition of `.until(...)` defines success.
/// The robot needs `force_sensor` in the deployment.
class SpiralSearch : public Generator {
 public:
  /// `pitch`, `radius` m, `speed` m/s. Throws NonFatalError(invalid_argument) unless they are finite and above 0.
  SpiralSearch(Robot& robot, const ForceLaw& law, double pitch, double radius, double speed);

  /// Starts the spiral at the tool's position, also after a pause.
  void start() override { angle_ = 0; }
  bool terminal_condition() override { return spiral(angle_).norm() >= radius_; }
  void next_state() override;

 private:
  Eigen::Vector2d spiral(double angle) const noexcept;

  Robot* robot_;
  ForceLaw law_;
  double pitch_, radius_, speed_;
  double angle_ = 0;  // phi at the end of the commanded motion
};

}  // namespace mrroc
