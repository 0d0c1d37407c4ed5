#include "language/joint_leg.hpp"

#include <array>
#include <cmath>
#include <ruckig/ruckig.hpp>
#include <string>

#include "language/joint_targets.hpp"
#include "language/motion_check.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr std::size_t kMost = kMaxJoints;
constexpr double kLegRounding = 1e-9;  // macrosteps

}  // namespace

struct JointLeg::Plan {
  explicit Plan(const Robot& robot) : check(robot) {
    // Ruckig validates the numbers of joints that there are not, too
    for (auto* values : {&input.current_position, &input.target_position, &input.max_velocity, &input.max_acceleration,
                         &input.max_jerk})
      values->fill(0);
  }

  ruckig::Ruckig<kMost> ruckig;  // of a fixed size: it does not allocate
  ruckig::InputParameter<kMost> input;
  ruckig::Trajectory<kMost> trajectory;
  DesiredState start;
  MotionCheck check;
};

JointLeg::JointLeg(const Robot& robot) : robot_(&robot), plan_(std::make_unique<Plan>(robot)) {
  plan_->input.synchronization = ruckig::Synchronization::Phase;
}

JointLeg::~JointLeg() = default;
JointLeg::JointLeg(JointLeg&&) noexcept = default;
JointLeg& JointLeg::operator=(JointLeg&&) noexcept = default;

void JointLeg::plan(const JointVector& target, double speed) {
  const RobotState& state = robot_->known_state();
  plan_->start = {state.desired_joints, state.desired_velocity, state.desired_acceleration};
  target_ = target;
  plan_checked(speed);
}

void JointLeg::plan(const JointVector& from, const JointVector& target, double speed) {
  plan_->start = DesiredState::resting_at(from);
  target_ = target;
  plan_checked(speed);
}

void JointLeg::plan_checked(double speed) {
  plan_->input.minimum_duration.reset();
  calculate(speed, 1);
  double when = 0;
  const MotionCheck::States states = [this](double time) { return at(time); };
  if (!bad(plan_->check.check(states, duration(), when))) return;
  const double step = robot_->step_duration(), shortest = duration();
  for (const double slower : kSlower) {
    const double whole = std::ceil(slower * shortest / step - kLegRounding) * step;
    if (plan_->start.at_rest()) {
      calculate(speed, whole / shortest);  // still straight
    } else {
      plan_->input.minimum_duration = whole;
      calculate(speed, 1);
    }
    if (!bad(plan_->check.check(states, duration(), when))) return;
  }
  plan_->check.require(states, duration());
}

void JointLeg::calculate(double speed, double stretch) {
  ruckig::InputParameter<kMost>& input = plan_->input;
  const auto& axes = robot_->parameters().axes;
  const double share = speed / stretch;
  for (std::size_t i = 0; i < kMost; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    input.enabled[i] = i < axes.size();
    if (!input.enabled[i]) continue;
    input.current_position[i] = plan_->start.position[row];
    input.current_velocity[i] = plan_->start.velocity[row];
    input.current_acceleration[i] = plan_->start.acceleration[row];
    input.target_position[i] = target_[row];
    input.max_velocity[i] = kVelocityShare * axes[i].velocity_max * share;
    input.max_acceleration[i] = kAccelerationShare * axes[i].acceleration_max * share * share;
    input.max_jerk[i] = kJerkShare * axes[i].jerk_max * share * share * share;
  }
  const ruckig::Result result = plan_->ruckig.calculate(input, plan_->trajectory);
  if (result != ruckig::Result::Working && result != ruckig::Result::Finished) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "no trajectory to the target (Ruckig result " + std::to_string(static_cast<int>(result)) + ")",
                        {robot_->task().process_name(), robot_->name(), 0, robot_->state().tick});
  }
}

DesiredState JointLeg::at(double time) const {
  const Eigen::Index joints = target_.size();
  if (over(time)) return DesiredState::resting_at(target_);
  std::array<double, kMost> position{}, velocity{}, acceleration{};
  plan_->trajectory.at_time(time, position, velocity, acceleration);
  return {Eigen::Map<const Eigen::VectorXd>(position.data(), joints),
          Eigen::Map<const Eigen::VectorXd>(velocity.data(), joints),
          Eigen::Map<const Eigen::VectorXd>(acceleration.data(), joints)};
}

double JointLeg::duration() const noexcept { return plan_->trajectory.get_duration(); }

void JointLeg::write(double time, RobotCommand& command) const {
  command.kind = CommandKind::joint;
  if (over(time)) {
    command.joints = target_;
    return;  // at rest
  }
  const DesiredState state = at(time);
  command.joints = state.position;
  command.joint_velocity = state.velocity;
  command.joint_acceleration = state.acceleration;
}

}  // namespace mrroc
