#include "language/joint_leg.hpp"

#include <array>
#include <ruckig/ruckig.hpp>
#include <string>

#include "language/joint_targets.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr std::size_t kMost = kMaxJoints;

}  // namespace

struct JointLeg::Plan {
  ruckig::Ruckig<kMost> ruckig;  // of a fixed size: it does not allocate
  ruckig::InputParameter<kMost> input;
  ruckig::Trajectory<kMost> trajectory;
};

JointLeg::JointLeg(const Robot& robot) : robot_(&robot), plan_(std::make_unique<Plan>()) {
  plan_->input.synchronization = ruckig::Synchronization::Phase;
}

JointLeg::~JointLeg() = default;
JointLeg::JointLeg(JointLeg&&) noexcept = default;
JointLeg& JointLeg::operator=(JointLeg&&) noexcept = default;

void JointLeg::plan(const JointVector& target, double speed) {
  const RobotState& state = robot_->known_state();
  ruckig::InputParameter<kMost>& input = plan_->input;
  const auto& axes = robot_->parameters().axes;
  target_ = target;
  for (std::size_t i = 0; i < kMost; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    input.enabled[i] = i < axes.size();
    if (!input.enabled[i]) continue;
    input.current_position[i] = state.desired_joints[row];
    input.current_velocity[i] = state.desired_velocity[row];
    input.current_acceleration[i] = state.desired_acceleration[row];
    input.target_position[i] = target[row];
    input.max_velocity[i] = kVelocityShare * axes[i].velocity_max * speed;
    input.max_acceleration[i] = kAccelerationShare * axes[i].acceleration_max * speed * speed;
    input.max_jerk[i] = kJerkShare * axes[i].jerk_max * speed * speed * speed;
  }
  const ruckig::Result result = plan_->ruckig.calculate(input, plan_->trajectory);
  if (result != ruckig::Result::Working && result != ruckig::Result::Finished) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "no trajectory to the target (Ruckig result " + std::to_string(static_cast<int>(result)) + ")",
                        {robot_->task().process_name(), robot_->name(), 0, state.tick});
  }
}

double JointLeg::duration() const noexcept { return plan_->trajectory.get_duration(); }

void JointLeg::write(double time, RobotCommand& command) const {
  command.kind = CommandKind::joint;
  if (over(time)) {
    command.joints = target_;
    return;  // at rest
  }
  std::array<double, kMost> position{}, velocity{}, acceleration{};
  plan_->trajectory.at_time(time, position, velocity, acceleration);
  const Eigen::Index joints = target_.size();
  command.joints = Eigen::Map<const Eigen::VectorXd>(position.data(), joints);
  command.joint_velocity = Eigen::Map<const Eigen::VectorXd>(velocity.data(), joints);
  command.joint_acceleration = Eigen::Map<const Eigen::VectorXd>(acceleration.data(), joints);
}

}  // namespace mrroc
