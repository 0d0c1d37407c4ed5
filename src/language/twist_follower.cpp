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
  const RobotState& state = robot_->known_state();
  pose_ = state.desired_pose;
  const Twist base = robot_->kinematics().jacobian(state.desired_joints) * state.desired_velocity;
  twist_ = turned(pose_.linear().transpose(), base);
  rate_.setZero();
}

void TwistFollower::step(const Twist& wanted) {
  if (!wanted.allFinite()) throw NonFatalError(ErrorCode::not_finite, "wanted tool velocity of " + robot_->name());
  ruckig::InputParameter<6>& input = plan_->input;
  const Eigen::Matrix3d back = axes_.transpose();
  Eigen::Map<Twist>(input.current_velocity.data()) = turned(back, twist_);
  Eigen::Map<Twist>(input.current_acceleration.data()) = turned(back, rate_);
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
  twist_ = there ? wanted : turned(axes_, Eigen::Map<const Twist>(velocity.data()));
  rate_ = there ? Twist(Twist::Zero()) : turned(axes_, Eigen::Map<const Twist>(acceleration.data()));
  pose_ = pose_ * exponential(turned(axes_, Eigen::Map<const Twist>(way.data())));
  pose_.linear() = orthonormal(pose_.linear());

  RobotCommand& command = robot_->command();
  command.kind = CommandKind::pose;
  command.pose = pose_;
  command.twist = turned(pose_.linear(), twist_);
  Twist rate = rate_;
  // the tool's axes turn: seen from the base its velocity changes by w x v in addition
  rate.head<3>() += twist_.tail<3>().cross(twist_.head<3>());
  command.twist_rate = turned(pose_.linear(), rate);
}

}  // namespace mrroc
