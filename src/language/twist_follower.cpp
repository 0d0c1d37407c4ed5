#include "language/twist_follower.hpp"

#include <cmath>
#include <ruckig/ruckig.hpp>

#include "language/rigid_motion.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

struct TwistFollower::Plan {
  ruckig::Ruckig<6> ruckig;
  ruckig::InputParameter<6> input;
  ruckig::Trajectory<6> trajectory;
};

TwistFollower::TwistFollower(Robot& robot, double acceleration, const Eigen::Matrix3d& axes)
    : robot_(&robot), axes_(axes), plan_(std::make_unique<Plan>()) {
  if (!(acceleration > 0) || !std::isfinite(acceleration)) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "acceleration " + std::to_string(acceleration) + ", expected a finite number above 0");
  }
  ruckig::InputParameter<6>& input = plan_->input;
  input.control_interface = ruckig::ControlInterface::Velocity;
  input.synchronization = ruckig::Synchronization::Phase;
  input.current_position.fill(0);
  input.target_acceleration.fill(0);
  input.max_acceleration.fill(acceleration);
  input.max_jerk.fill(kJerkRate * acceleration);
}

TwistFollower::~TwistFollower() = default;
TwistFollower::TwistFollower(TwistFollower&&) noexcept = default;
TwistFollower& TwistFollower::operator=(TwistFollower&&) noexcept = default;

void TwistFollower::start() {
  pose_ = robot_->known_state().desired_pose;
  motion_ = in_own_axes(desired_motion(*robot_));
}

void TwistFollower::step(const Twist& wanted) {
  if (!wanted.allFinite()) throw NonFatalError(ErrorCode::not_finite, "wanted tool velocity of " + robot_->name());
  ruckig::InputParameter<6>& input = plan_->input;
  const Eigen::Matrix3d back = axes_.transpose();
  Eigen::Map<Twist>(input.current_velocity.data()) = turned(back, motion_.twist);
  Eigen::Map<Twist>(input.current_acceleration.data()) = turned(back, motion_.rate);
  Eigen::Map<Twist>(input.target_velocity.data()) = turned(back, wanted);
  const ruckig::Result result = plan_->ruckig.calculate(input, plan_->trajectory);
  if (result != ruckig::Result::Working && result != ruckig::Result::Finished) {
    throw NonFatalError(
        ErrorCode::invalid_argument,
        "no way to the wanted tool velocity (Ruckig result " + std::to_string(static_cast<int>(result)) + ")",
        {robot_->task().process_name(), robot_->name(), 0, 0});
  }
  std::array<double, 6> way{}, velocity{}, acceleration{};
  plan_->trajectory.at_time(robot_->step_duration(), way, velocity, acceleration);
  // the end itself, not what rounding makes of it: rest is rest
  const bool there = plan_->trajectory.get_duration() <= robot_->step_duration();
  motion_.twist = there ? wanted : turned(axes_, Eigen::Map<const Twist>(velocity.data()));
  motion_.rate = there ? Twist(Twist::Zero()) : turned(axes_, Eigen::Map<const Twist>(acceleration.data()));
  pose_ = pose_ * exponential(turned(axes_, Eigen::Map<const Twist>(way.data())));
  pose_.linear() = orthonormal(pose_.linear());

  command_motion(robot_->command(), in_base_axes(pose_, motion_));
}

}  // namespace mrroc
