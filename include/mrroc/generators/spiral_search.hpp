#pragma once

#include "mrroc/force_law.hpp"
#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

/// Looks for a hole: while the tool follows a force law (as in ForceControl), it goes in the x-y plane of its own axes
/// along an Archimedean spiral around where it starts, at a constant speed,
///
///   (x, y) = r (cos phi, sin phi),  r = pitch phi / (2 pi),  dphi/dt = speed / sqrt(r^2 + (pitch / (2 pi))^2),
///
/// commanded as the velocity from macrostep to macrostep. The law should press along z and leave x and y unguarded. No
/// place within `radius` is farther from the spiral than half the pitch: for a peg in a hole choose it below the
/// clearance of the diameters.
///
/// Ends on its own when r has come to `radius`: nothing has been found. What finding means is the condition of
/// `.until(...)`. The robot needs `force_sensor` in the deployment.
class SpiralSearch : public Generator {
 public:
  /// `pitch`, `radius` m, `speed` m/s. Throws NonFatalError(invalid_argument) unless they are finite and above 0.
  SpiralSearch(Robot& robot, const ForceLaw& law, double pitch, double radius, double speed);

  /// From the centre; after a pause too: from where the tool then is.
  void start() override { angle_ = 0; }
  bool terminal_condition() override { return spiral(angle_).norm() >= radius_; }
  void next_state() override;

 private:
  Eigen::Vector2d spiral(double angle) const noexcept;

  Robot* robot_;
  ForceLaw law_;
  double pitch_, radius_, speed_;
  double angle_ = 0;  // phi at the end of what has been commanded
};

}  // namespace mrroc
