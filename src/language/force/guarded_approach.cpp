#include "mrroc/generators/guarded_approach.hpp"

#include <algorithm>
#include <cmath>

#include "core/require.hpp"
#include "language/servoing/twist_follower.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

/// Share of the acceleration for the profile; the remainder is for following it.
constexpr double kShare = 0.5;
constexpr double kApproachGain = 4;  // 1/s
constexpr double kGainSteps = 0.2;   // the gain times the macrostep, at most

}  // namespace

GuardedApproach::GuardedApproach(Robot& robot, Range range, const Eigen::Vector3d& direction, double speed,
                                 double stop_distance, double acceleration, int patience)
    : Generator("GuardedApproach"),
      robot_(&robot),
      range_(std::move(range)),
      direction_(direction.normalized()),
      speed_(speed),
      stop_distance_(stop_distance),
      acceleration_(acceleration),
      patience_(patience),
      follower_(std::make_unique<TwistFollower>(
          robot, acceleration,
          Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), direction_).toRotationMatrix())) {
  if (!direction.allFinite())
    throw NonFatalError(ErrorCode::not_finite, "direction of the approach of " + robot.name());
  require_above_zero("GuardedApproach", "length of the direction", direction.norm());
  require_above_zero("GuardedApproach", "speed", speed);
  require_finite("GuardedApproach", "stop distance", stop_distance);
  require_not_negative("GuardedApproach", "patience", patience);
  if (!range_) throw NonFatalError(ErrorCode::invalid_argument, "GuardedApproach without a function for the range");
}

GuardedApproach::~GuardedApproach() = default;
GuardedApproach::GuardedApproach(GuardedApproach&&) noexcept = default;
GuardedApproach& GuardedApproach::operator=(GuardedApproach&&) noexcept = default;

void GuardedApproach::start() {
  follower_->start();
  remaining_.reset();
  lost_ = 0;
}

bool GuardedApproach::terminal_condition() {
  const std::optional<double> range = range_();
  remaining_.reset();
  if (range && std::isfinite(*range)) {
    const RobotState& state = robot_->state();
    const Eigen::Vector3d ahead = follower_->pose().translation() - state.pose.translation();
    remaining_ = *range - stop_distance_ - ahead.dot(state.pose.linear() * direction_);
  }
  return remaining_ && *remaining_ <= kTolerance && follower_->at_rest();
}

void GuardedApproach::next_state() {
  Twist wanted = Twist::Zero();
  if (remaining_) {
    lost_ = 0;
    const double speed = follower_->twist().head<3>().dot(direction_);
    wanted.head<3>() = direction_ * allowed_speed(*remaining_ - std::max(speed, 0.0) * robot_->step_duration());
  } else if (++lost_ > patience_) {
    throw NonFatalError(ErrorCode::sensor_not_ready, "no range for " + std::to_string(patience_) + " steps",
                        {robot_->task().process_name(), robot_->name(), 0, robot_->state().tick});
  }
  follower_->step(wanted);
}

double GuardedApproach::allowed_speed(double remaining) const noexcept {
  if (remaining <= kTolerance) return 0;
  const double a = kShare * acceleration_;
  const double k = std::min(kApproachGain, kGainSteps / robot_->step_duration());
  const double knee = a / (k * k);
  return std::min(speed_, remaining < knee ? k * remaining : std::sqrt(2 * a * (remaining - 0.5 * knee)));
}

}  // namespace mrroc
