#include "mrroc/generators/joint_line.hpp"

#include <cmath>
#include <ruckig/ruckig.hpp>

#include "language/joint_targets.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

struct JointLine::Plan {
  explicit Plan(std::size_t joints)
      : ruckig(joints), trajectory(joints), position(joints), velocity(joints), acceleration(joints) {}
  ruckig::Ruckig<ruckig::DynamicDOFs> ruckig;
  ruckig::Trajectory<ruckig::DynamicDOFs> trajectory;
  std::vector<double> position, velocity, acceleration;  // scratch, so that sampling does not allocate
  double time = 0;                                       // of the macrostep commanded last

  /// Sums of step durations are not exact.
  bool over() const { return time >= trajectory.get_duration() - 1e-9; }
};

JointLine::JointLine(Robot& robot, const JointVector& target, double speed)
    : Generator("JointLine"), robot_(&robot), to_pose_(false), target_(target), speed_(speed) {
  check_speed(speed);
  check_target(target);
}

JointLine::JointLine(Robot& robot, const Pose& target, double speed)
    : Generator("JointLine"), robot_(&robot), to_pose_(true), target_pose_(target), speed_(speed) {
  check_speed(speed);
  if (!target.matrix().allFinite()) throw NonFatalError(ErrorCode::not_finite, "target pose of " + robot.name());
}

JointLine::~JointLine() = default;
JointLine::JointLine(JointLine&&) noexcept = default;
JointLine& JointLine::operator=(JointLine&&) noexcept = default;

void JointLine::check_target(const JointVector& target) const { check_joints(*robot_, target, "target"); }

void JointLine::start() {
  const RobotState& state = robot_->known_state();
  const ErrorOrigin origin{robot_->task().process_name(), robot_->name(), 0, state.tick};
  if (to_pose_) {
    const JointVector joints = joints_of(*robot_, target_pose_, state.desired_joints, "target");
    check_target(joints);
    target_ = joints;
  }
  const auto& axes = robot_->parameters().axes;
  plan_ = std::make_unique<Plan>(axes.size());
  ruckig::InputParameter<ruckig::DynamicDOFs> input(axes.size());
  input.synchronization = ruckig::Synchronization::Phase;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    input.current_position[i] = state.desired_joints[row];
    input.current_velocity[i] = state.desired_velocity[row];
    input.current_acceleration[i] = state.desired_acceleration[row];
    input.target_position[i] = target_[row];
    input.max_velocity[i] = kVelocityShare * axes[i].velocity_max * speed_;
    input.max_acceleration[i] = kAccelerationShare * axes[i].acceleration_max * speed_ * speed_;
    input.max_jerk[i] = kJerkShare * axes[i].jerk_max * speed_ * speed_ * speed_;
  }
  const ruckig::Result result = plan_->ruckig.calculate(input, plan_->trajectory);
  if (result != ruckig::Result::Working && result != ruckig::Result::Finished) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "no trajectory to the target (Ruckig result " + std::to_string(static_cast<int>(result)) + ")",
                        origin);
  }
}

bool JointLine::terminal_condition() { return plan_->over(); }

void JointLine::next_state() {
  plan_->time += robot_->step_duration();
  RobotCommand& command = robot_->command();
  command.kind = CommandKind::joint;
  if (plan_->over()) {
    command.joints = target_;
    return;  // at rest
  }
  plan_->trajectory.at_time(plan_->time, plan_->position, plan_->velocity, plan_->acceleration);
  const auto joints = static_cast<Eigen::Index>(plan_->position.size());
  command.joints = Eigen::Map<const Eigen::VectorXd>(plan_->position.data(), joints);
  command.joint_velocity = Eigen::Map<const Eigen::VectorXd>(plan_->velocity.data(), joints);
  command.joint_acceleration = Eigen::Map<const Eigen::VectorXd>(plan_->acceleration.data(), joints);
}

double JointLine::duration() const noexcept { return plan_ ? plan_->trajectory.get_duration() : 0; }

}  // namespace mrroc
