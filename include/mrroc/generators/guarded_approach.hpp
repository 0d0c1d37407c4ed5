#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

class TwistFollower;

/// Moves the tool along one of its directions towards an object whose distance d a range sensor measures along that
/// direction, slowly enough to stop at the distance d_stop:
///
///   v = min(speed, sqrt(2 a (r - r0 / 2)))   and  v = k r  for r < r0 = a / k^2,   r = d - d_stop,
///
/// with a half of `acceleration` and k = 4 / s (less for macrosteps longer than 50 ms: 0.2 / duration). v is followed
/// with at most `acceleration` and a jerk of 10 / s times that; it is never negative: the tool does not retreat from an
/// approaching object. r is predicted for the end of the coming macrostep: the path from the measured pose to the
/// desired one, and the path at the present speed, are subtracted from the reading. So the reading must belong to the
/// tick of the robot's state, as that of an interactive sensor does. A reading that is older by t lets the tool come
/// closer by up to v t during the motion, but not where it stops.
///
/// Ends on its own when r is at most kTolerance and the motion is at rest: the tool is then between d_stop and d_stop +
/// kTolerance if the readings are right. If it starts at rest at that distance, it commands nothing.
///
/// When the reading is lost (the function returns nothing or NaN), the tool slows down to a stop; it continues with the
/// next reading. After `patience` consecutive steps without a reading NonFatalError(sensor_not_ready) is thrown. An
/// error of the sensor itself is thrown by the Move that has the sensor in its list.
class GuardedApproach : public Generator {
 public:
  /// The distance, m; nothing while it is unknown. Called once per step, must not allocate.
  using Range = std::function<std::optional<double>()>;

  /// `direction` in tool axes, of any nonzero length; `speed` m/s, above 0; `stop_distance` m; `acceleration` m/s^2,
  /// above 0; `patience` at least 0. Throws NonFatalError (invalid_argument, not_finite).
  GuardedApproach(Robot& robot, Range range, const Eigen::Vector3d& direction, double speed, double stop_distance,
                  double acceleration = 0.2, int patience = 50);
  ~GuardedApproach() override;
  GuardedApproach(GuardedApproach&&) noexcept;
  GuardedApproach& operator=(GuardedApproach&&) noexcept;

  void start() override;
  bool terminal_condition() override;
  void next_state() override;

  static constexpr double kTolerance = 5e-4;  ///< m

 private:
  double allowed_speed(double remaining) const noexcept;

  Robot* robot_;
  Range range_;
  Eigen::Vector3d direction_;  ///< of length 1, in tool axes
  double speed_;
  double stop_distance_;
  double acceleration_;
  int patience_;
  std::unique_ptr<TwistFollower> follower_;
  std::optional<double> remaining_;  ///< r at the end of the commanded motion, from this step's reading
  int lost_ = 0;                     ///< consecutive steps without a reading
};

}  // namespace mrroc
