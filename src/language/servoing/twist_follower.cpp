#include "language/servoing/twist_follower.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <ruckig/ruckig.hpp>

#include "core/require.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/joints/joint_targets.hpp"
#include "language/tool_motion.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kBrakeShare = 0.5;    // of the joints' shares: the remainder is for the change of the posture
constexpr double kMovingTwist = 1e-9;  // m/s, rad/s

}  // namespace

struct TwistFollower::Plan {
  ruckig::Ruckig<6> ruckig;
  ruckig::InputParameter<6> input;
  ruckig::Trajectory<6> trajectory;
};

TwistFollower::TwistFollower(Robot& robot, double acceleration, const Eigen::Matrix3d& axes)
    : robot_(&robot), axes_(axes), plan_(std::make_unique<Plan>()), acceleration_(acceleration) {
  require_above_zero("motion after a twist", "acceleration", acceleration);
  ruckig::InputParameter<6>& input = plan_->input;
  input.control_interface = ruckig::ControlInterface::Velocity;
  input.synchronization = ruckig::Synchronization::Phase;
  input.current_position.fill(0);
  input.target_acceleration.fill(0);
}

TwistFollower::~TwistFollower() = default;
TwistFollower::TwistFollower(TwistFollower&&) noexcept = default;
TwistFollower& TwistFollower::operator=(TwistFollower&&) noexcept = default;

void TwistFollower::start() {
  pose_ = robot_->known_state().desired_pose;
  motion_ = in_own_axes(desired_motion(*robot_));
  find_brake();
}

void TwistFollower::find_brake() {
  braking_ = false;
  const Twist now = rotate_twist(axes_.transpose(), motion_.twist);
  if (now.isZero(kMovingTwist)) return;
  const Eigen::Matrix3d to_base = pose_.linear() * axes_;
  Eigen::MatrixXd jacobian = robot_->kinematics().jacobian(robot_->state().desired_joints);
  for (Eigen::Index i = 0; i < jacobian.cols(); ++i)
    jacobian.col(i) = rotate_twist(to_base.transpose(), Twist(jacobian.col(i)));
  const Eigen::MatrixXd inverse = jacobian.completeOrthogonalDecomposition().pseudoInverse();
  const Twist moves = (now.array().abs() > kMovingTwist).cast<double>();
  const Eigen::VectorXd share = inverse.cwiseAbs() * moves;
  brake_acceleration_ = brake_jerk_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < robot_->parameters().axes.size(); ++i) {
    const AxisParameters& axis = robot_->parameters().axes[i];
    const double part = share[static_cast<Eigen::Index>(i)];
    if (part == 0) continue;
    brake_acceleration_ =
        std::min(brake_acceleration_, kBrakeShare * kAccelerationShare * axis.acceleration_max / part);
    brake_jerk_ = std::min(brake_jerk_, kBrakeShare * kJerkShare * axis.jerk_max / part);
  }
  braking_ = std::isfinite(brake_acceleration_) && brake_acceleration_ > acceleration_ &&
             brake_jerk_ > kJerkRate * acceleration_;
}

void TwistFollower::step(const Twist& wanted) {
  if (!wanted.allFinite()) throw NonFatalError(ErrorCode::not_finite, "desired tool velocity of " + robot_->name());
  ruckig::InputParameter<6>& input = plan_->input;
  const Eigen::Matrix3d back = axes_.transpose();
  Eigen::Map<Twist>(input.current_velocity.data()) = rotate_twist(back, motion_.twist);
  Eigen::Map<Twist>(input.current_acceleration.data()) = rotate_twist(back, motion_.rate);
  Twist goal = wanted;  // of this step
  if (braking_) {
    const Twist now = rotate_twist(back, motion_.twist), asked = rotate_twist(back, wanted), none = Twist::Zero();
    const Twist slower = asked.cwiseMax(now.cwiseMin(none)).cwiseMin(now.cwiseMax(none));
    braking_ = !(slower - now).isZero(kMovingTwist);
    if (braking_) goal = rotate_twist(axes_, slower);
  }
  input.max_acceleration.fill(braking_ ? brake_acceleration_ : acceleration_);
  input.max_jerk.fill(braking_ ? brake_jerk_ : kJerkRate * acceleration_);
  Eigen::Map<Twist>(input.target_velocity.data()) = rotate_twist(back, goal);
  const ruckig::Result result = plan_->ruckig.calculate(input, plan_->trajectory);
  if (result != ruckig::Result::Working && result != ruckig::Result::Finished) {
    throw NonFatalError(
        ErrorCode::invalid_argument,
        "no trajectory to the desired tool velocity (Ruckig result " + std::to_string(static_cast<int>(result)) + ")",
        {robot_->task().process_name(), robot_->name(), 0, 0});
  }
  std::array<double, 6> way{}, velocity{}, acceleration{};
  plan_->trajectory.at_time(robot_->step_duration(), way, velocity, acceleration);
  // the end itself, without rounding errors: rest is exact
  const bool there = plan_->trajectory.get_duration() <= robot_->step_duration();
  motion_.twist = there ? goal : rotate_twist(axes_, Eigen::Map<const Twist>(velocity.data()));
  motion_.rate = there ? Twist(Twist::Zero()) : rotate_twist(axes_, Eigen::Map<const Twist>(acceleration.data()));
  if (there) braking_ = false;
  pose_ = pose_ * exp_twist(rotate_twist(axes_, Eigen::Map<const Twist>(way.data())));
  pose_.linear() = orthonormal(pose_.linear());

  command_motion(robot_->command(), in_base_axes(pose_, motion_));
}

}  // namespace mrroc
