#include "language/joint_leg.hpp"

#include <array>
#include <cmath>
#include <ruckig/ruckig.hpp>
#include <string>

namespace mrroc {

namespace {

// of the robot's limits, as JointLine has them
constexpr double kVelocityShare = 0.99;
constexpr double kAccelerationShare = 0.9;
constexpr double kJerkShare = 0.45;

constexpr std::size_t kMost = kMaxJoints;

}  // namespace

struct JointLeg::Plan {
  ruckig::Ruckig<kMost> ruckig;  // of a fixed size: it does not allocate
  ruckig::InputParameter<kMost> input;
  ruckig::Trajectory<kMost> trajectory;
};

JointLeg::JointLeg(const RobotParameters& parameters) : parameters_(&parameters), plan_(std::make_unique<Plan>()) {
  plan_->input.synchronization = ruckig::Synchronization::Phase;
}

JointLeg::~JointLeg() = default;
JointLeg::JointLeg(JointLeg&&) noexcept = default;
JointLeg& JointLeg::operator=(JointLeg&&) noexcept = default;

void JointLeg::plan(const RobotState& state, const JointVector& target, double speed) {
  ruckig::InputParameter<kMost>& input = plan_->input;
  const auto& axes = parameters_->axes;
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
                        "no trajectory to the target (Ruckig result " + std::to_string(static_cast<int>(result)) + ")");
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

void check_joints(const RobotParameters& parameters, const JointVector& target, const char* what) {
  const auto& axes = parameters.axes;
  if (static_cast<std::size_t>(target.size()) != axes.size()) {
    throw NonFatalError(ErrorCode::invalid_argument, std::string{what} + " has " + std::to_string(target.size()) +
                                                         " joints, expected " + std::to_string(axes.size()));
  }
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double position = target[static_cast<Eigen::Index>(i)];
    if (!std::isfinite(position)) throw NonFatalError(ErrorCode::not_finite, std::string{what} + ", " + axes[i].name);
    if (position >= axes[i].position_min && position <= axes[i].position_max) continue;
    throw NonFatalError(ErrorCode::joint_limit, std::string{what} + ": joint " + axes[i].name + " is " +
                                                    std::to_string(position) + ", expected " +
                                                    std::to_string(axes[i].position_min) + " to " +
                                                    std::to_string(axes[i].position_max));
  }
}

}  // namespace mrroc
