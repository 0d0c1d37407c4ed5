#include "mrroc/tracker.hpp"

#include <cmath>
#include <vector>

#include "language/joints/joint_targets.hpp"
#include "language/joints/motor_range.hpp"
#include "language/limits.hpp"
#include "language/tracking/axis_tracker.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

struct Tracker::State {
  Robot* robot;
  double speed;
  double step;  // s, for which `axes` were made
  std::vector<AxisTracker> axes;
  JointVector rest, joints;
  bool arrived = false;

  State(Robot& moved, double part) : robot(&moved), speed(part), step(moved.step_duration()) {
    const std::size_t count = moved.parameters().axes.size();
    for (std::size_t i = 0; i < count; ++i) axes.emplace_back(step);
    rest = joints = JointVector::Zero(static_cast<Eigen::Index>(count));
  }

  [[noreturn]] void refuse(ErrorCode code, const std::string& what) const {
    throw NonFatalError(code, "Tracker: " + what,
                        {robot->task().process_name(), robot->name(), 0, robot->state().tick});
  }
};

Tracker::Tracker(Robot& robot, double speed) : state_(std::make_unique<State>(robot, speed)) {
  if (!(speed > 0 && speed <= 1))
    throw NonFatalError(ErrorCode::invalid_argument,
                        "Tracker: speed " + std::to_string(speed) + ", expected above 0, at most 1");
}

Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

bool Tracker::arrived() const noexcept { return state_->arrived; }

void Tracker::to(const JointVector& target) { to(target, state_->rest); }

void Tracker::to(const Pose& target) {
  State& s = *state_;
  if (!target.matrix().allFinite()) s.refuse(ErrorCode::not_finite, "target pose");
  s.joints = s.robot->state().desired_joints;
  const ErrorCode code = s.robot->kinematics().inverse(target, s.robot->state().desired_joints, s.joints);
  if (code != ErrorCode::none && code != ErrorCode::singular) s.refuse(code, "target pose");
  to(s.joints, s.rest);
}

void Tracker::to(const JointVector& target, const JointVector& velocity) {
  State& s = *state_;
  const RobotState& from = s.robot->state();
  const auto& parameters = s.robot->parameters().axes;
  const Eigen::Index count = s.rest.size();
  if (target.size() != count || velocity.size() != count)
    s.refuse(ErrorCode::invalid_argument, std::to_string(target.size()) + " joints and " +
                                              std::to_string(velocity.size()) + " velocities, expected " +
                                              std::to_string(count));
  if (!target.allFinite() || !velocity.allFinite()) s.refuse(ErrorCode::not_finite, "target");
  check_joints(*s.robot, target, "target");
  check_motors(*s.robot, target, "target,");
  if (const double step = s.robot->step_duration(); step != s.step) s = State(*s.robot, s.speed);
  RobotCommand& command = s.robot->command();
  command.kind = CommandKind::joint;
  command.joints = command.joint_velocity = command.joint_acceleration = s.rest;
  s.arrived = true;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    const AxisParameters& limits = parameters[axis];
    const double moving = velocity[i], there = target[i];
    AxisBounds bounds{s.speed * limits.velocity_max - std::abs(moving), s.speed * s.speed * limits.acceleration_max,
                      s.speed * s.speed * s.speed * limits.jerk_max};
    if (!(bounds.velocity > 0))
      s.refuse(ErrorCode::velocity_limit, "target of joint " + limits.name + " at " +
                                              number_text(moving, s.speed * limits.velocity_max) + ", limit " +
                                              number_text(s.speed * limits.velocity_max, moving));
    const AxisMotion now{from.desired_joints[i] - there, from.desired_velocity[i] - moving,
                         from.desired_acceleration[i]};
    AxisMotion end = s.axes[axis].after(now, s.axes[axis].jerk(now, bounds));
    const bool there_now =
        std::abs(end.position) < 1e-9 && std::abs(end.velocity) < 1e-9 && std::abs(end.acceleration) < 1e-7;
    if (there_now) end = {};
    s.arrived = s.arrived && there_now;
    command.joints[i] = there + moving * s.step + end.position;
    command.joint_velocity[i] = moving + end.velocity;
    command.joint_acceleration[i] = end.acceleration;
  }
}

}  // namespace mrroc
