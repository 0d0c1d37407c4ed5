#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"

namespace mrroc {

class TwistFollower;

/// Moves the tool along one of its directions towards something whose distance d a range sensor measures along that
/// direction, so slowly that it can stop at the distance d_stop:
///
///   v = min(speed, sqrt(2 a (r - r0 / 2)))   and  v = k r  for r < r0 = a / k^2,   r = d - d_stop,
///
/// with a half of `acceleration` and k = 4 / s (less for macrosteps longer than 50 ms: 0.2 / duration). v is followed
/// with at most `acceleration` and a jerk of 10 / s times that; it is never negative: what comes nearer on its own is
/// not run away from. r is that of the end of the coming macrostep: from the reading the way between the measured pose
/// and the desired one, and the way at the present speed, are taken off. So the reading has to be of the tick of the
/// robot's state, as an interactive sensor's is; one that is older by t lets the tool come nearer by up to v t while it
/// moves, and by nothing where it stops.
///
/// Ends on its own when r is at most kTolerance and the motion is at rest: the tool stands between d_stop and d_stop +
/// kTolerance, when the readings are right. At that distance already, and at rest, it commands nothing.
///
/// A reading that is lost (the function gives nothing, or no number) slows the tool to a stop; it continues when there
/// is one again. After `patience` steps in a row without one NonFatalError(sensor_not_ready) is thrown. An error of the
/// sensor itself is thrown by the Move that has it in its list.
class GuardedApproach : public Generator {
 public:
  /// The distance, m; nothing while it is not known. Called once per step, must not allocate.
  using Range = std::function<std::optional<double>()>;

  /// `direction` in tool axes, of any length but 0; `speed` m/s, above 0; `stop_distance` m; `acceleration` m/s^2,
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
  std::optional<double> remaining_;  ///< r at the end of what has been commanded, of this step's reading
  int lost_ = 0;                     ///< steps in a row without a reading
};

}  // namespace mrroc
