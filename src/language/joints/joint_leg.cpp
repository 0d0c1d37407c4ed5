#include "language/joints/joint_leg.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <ruckig/ruckig.hpp>
#include <string>

#include "language/joints/joint_targets.hpp"
#include "language/motion_check.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr std::size_t kMost = kMaxJoints;
constexpr double kLegRounding = 1e-9;  // macrosteps
constexpr double kNaturalTime =
    0.05;  // slower motions are planned in stretched time: s^3 is too small a jerk for Ruckig
constexpr double kWithin = 1 + 1e-6;    // of the limits: rounding of a state
constexpr double kBeyondTarget = 1e-9;  // rad or m: rounding of a position

using JointValues = std::array<double, kMost>;
using AxisSet = std::bitset<kMost>;

struct JointLimits {
  JointValues velocity{}, acceleration{}, jerk{};
};

/// The shares of the limits, scaled by `speed`, speed^2, speed^3.
JointLimits limits_at(const std::vector<AxisParameters>& axes, double speed) {
  JointLimits limits;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    limits.velocity[i] = kVelocityShare * axes[i].velocity_max * speed;
    limits.acceleration[i] = kAccelerationShare * axes[i].acceleration_max * speed * speed;
    limits.jerk[i] = kJerkShare * axes[i].jerk_max * speed * speed * speed;
  }
  return limits;
}

bool is_planned(ruckig::Result result) {
  return result == ruckig::Result::Working || result == ruckig::Result::Finished;
}

}  // namespace

struct JointLeg::Plan {
  explicit Plan(const Robot& robot) : check(robot) {
    // Ruckig also validates the numbers of disabled joints
    for (auto* each : {&input, &slowing_input}) {
      for (auto* values : {&each->current_position, &each->target_position, &each->max_velocity,
                           &each->max_acceleration, &each->max_jerk})
        values->fill(0);
    }
  }

  struct Motion {
    JointValues position{}, velocity{}, acceleration{};
    bool at_rest() const {
      const auto zero = [](double value) { return value == 0; };
      return std::all_of(velocity.begin(), velocity.end(), zero) &&
             std::all_of(acceleration.begin(), acceleration.end(), zero);
    }
  };

  ruckig::Ruckig<kMost> ruckig;  // of a fixed size: it does not allocate
  ruckig::InputParameter<kMost> input, slowing_input;
  ruckig::Trajectory<kMost> trajectory, slowing;
  ruckig::Result result = ruckig::Result::Working;  // of the last calculation of `trajectory`
  std::size_t axes = 0;
  Motion start, slowed;
  JointValues rest{};       // ends of the shortest stops
  double slowing_time = 0;  // s, before the trajectory begins
  double pace = 1;          // of the trajectory's time: planned `1 / pace` times as fast
  double least_time = 0;    // s, of the whole motion
  MotionPace slowness;      // of the whole motion
  MotionCheck check;

  /// From `from` at `speed`; false when Ruckig finds no solution.
  bool run(const Motion& from, const std::vector<AxisParameters>& parameters, double speed) {
    pace = speed < kNaturalTime ? speed : 1;
    const JointLimits limits = limits_at(parameters, pace == 1 ? speed : 1);
    for (std::size_t i = 0; i < axes; ++i) {
      input.current_position[i] = from.position[i];
      input.current_velocity[i] = from.velocity[i] / pace;
      input.current_acceleration[i] = from.acceleration[i] / (pace * pace);
      input.max_velocity[i] = limits.velocity[i];
      input.max_acceleration[i] = limits.acceleration[i];
      input.max_jerk[i] = limits.jerk[i];
    }
    input.minimum_duration.reset();
    if (least_time > slowing_time) input.minimum_duration = pace * (least_time - slowing_time);
    result = ruckig.calculate(input, trajectory);
    return is_planned(result);
  }

  /// At the robot's limits, each axis on its own: to rest where `stopped` is set, else to the velocity at zero
  /// acceleration, but at most `speed` of the limits. Nothing when Ruckig finds no solution.
  bool slow_down(const std::vector<AxisParameters>& parameters, AxisSet stopped, double speed) {
    const JointLimits full = limits_at(parameters, 1);
    for (std::size_t i = 0; i < axes; ++i) {
      slowing_input.current_position[i] = start.position[i];
      slowing_input.current_velocity[i] = start.velocity[i];
      slowing_input.current_acceleration[i] = start.acceleration[i];
      slowing_input.max_acceleration[i] = full.acceleration[i];
      slowing_input.max_jerk[i] = full.jerk[i];
      const double a = start.acceleration[i], soonest = start.velocity[i] + 0.5 * a * std::abs(a) / full.jerk[i];
      const double most = stopped[i] ? 0 : speed * full.velocity[i];
      slowing_input.target_velocity[i] = std::clamp(soonest, -most, most);
    }
    if (!is_planned(ruckig.calculate(slowing_input, slowing))) return false;
    slowing_time = slowing.get_duration();
    slowing.at_time(slowing_time, slowed.position, slowed.velocity, slowed.acceleration);
    std::copy_n(slowing_input.target_velocity.begin(), axes, slowed.velocity.begin());
    slowed.acceleration.fill(0);
    return true;
  }

  /// Whether the start is a possible state of a motion at `speed`.
  bool starts_within(const JointLimits& limits) const {
    for (std::size_t i = 0; i < axes; ++i) {
      const double v = start.velocity[i], a = start.acceleration[i];
      const double later = v + 0.5 * a * std::abs(a) / limits.jerk[i];  // when the acceleration has become 0
      if (std::max(std::abs(v), std::abs(later)) > kWithin * limits.velocity[i] ||
          std::abs(a) > kWithin * limits.acceleration[i])
        return false;
    }
    return true;
  }

  /// The axes that leave the range of their start, their target and the end of their shortest stop.
  AxisSet beyond() const {
    std::array<ruckig::Bound, kMost> extrema;
    trajectory.get_position_extrema(extrema);
    AxisSet found;
    for (std::size_t i = 0; i < axes; ++i) {
      const double low = std::min({start.position[i], input.target_position[i], rest[i]}) - kBeyondTarget;
      const double high = std::max({start.position[i], input.target_position[i], rest[i]}) + kBeyondTarget;
      found[i] = extrema[i].min < low || extrema[i].max > high;
    }
    return found;
  }
};

JointLeg::JointLeg(const Robot& robot) : robot_(&robot), plan_(std::make_unique<Plan>(robot)) {
  Plan& plan = *plan_;
  plan.axes = robot.parameters().axes.size();
  plan.input.synchronization = ruckig::Synchronization::Phase;
  plan.slowing_input.control_interface = ruckig::ControlInterface::Velocity;
  plan.slowing_input.synchronization = ruckig::Synchronization::None;
  for (std::size_t i = 0; i < kMost; ++i) plan.input.enabled[i] = plan.slowing_input.enabled[i] = i < plan.axes;
}

JointLeg::~JointLeg() = default;
JointLeg::JointLeg(JointLeg&&) noexcept = default;
JointLeg& JointLeg::operator=(JointLeg&&) noexcept = default;

void JointLeg::plan(const JointVector& target, double speed) {
  const RobotState& state = robot_->known_state();
  begin({state.desired_joints, state.desired_velocity, state.desired_acceleration}, target);
  plan_checked(speed);
}

void JointLeg::plan(const JointVector& from, const JointVector& target, double speed) {
  begin(DesiredState::resting_at(from), target);
  plan_checked(speed);
}

void JointLeg::begin(const DesiredState& start, const JointVector& target) {
  Plan& plan = *plan_;
  target_ = target;
  for (std::size_t i = 0; i < plan.axes; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    plan.start.position[i] = start.position[row];
    plan.start.velocity[i] = start.velocity[row];
    plan.start.acceleration[i] = start.acceleration[row];
    plan.input.target_position[i] = target[row];
  }
}

void JointLeg::plan_checked(double speed) {
  plan_->least_time = 0;
  calculate(speed);
  double when = 0;
  const MotionCheck::States states = [this](double time) { return at(time); };
  if (!bad(plan_->check.check(states, duration(), when, plan_->slowness))) return;
  const double step = robot_->step_duration(), shortest = duration();
  for (const double slower : kSlower) {
    const double whole = std::ceil(slower * shortest / step - kLegRounding) * step;
    if (plan_->start.at_rest()) {
      calculate(speed * shortest / whole);  // still straight
    } else {
      plan_->least_time = whole;
      calculate(speed);
    }
    if (!bad(plan_->check.check(states, duration(), when, plan_->slowness))) return;
  }
  plan_->check.require(states, duration(), plan_->slowness);
}

void JointLeg::calculate(double speed) {
  const auto& axes = robot_->parameters().axes;
  Plan& plan = *plan_;
  plan.slowing_time = 0;
  plan.slowness = {0, speed};
  if (speed == 1 || plan.start.at_rest()) {
    if (plan.run(plan.start, axes, speed)) return;
    throw_no_trajectory();
  }
  AxisSet all;
  for (std::size_t i = 0; i < plan.axes; ++i) all[i] = true;
  if (!plan.slow_down(axes, all, speed)) throw_no_trajectory();
  plan.rest = plan.slowed.position;
  plan.slowing_time = 0;
  AxisSet stopped;
  if (plan.starts_within(limits_at(axes, speed)) && plan.run(plan.start, axes, speed)) {
    stopped = plan.beyond();
    if (stopped.none()) return;
  }
  // axes that would overshoot with the scaled limits are stopped with the unscaled ones, as few as necessary
  while (stopped != all) {
    if (!plan.slow_down(axes, stopped, speed) || !plan.run(plan.slowed, axes, speed)) break;
    plan.slowness.from = plan.slowing_time;
    const AxisSet beyond = plan.beyond() & ~stopped;
    if (beyond.none()) return;
    stopped |= beyond;
  }
  if (!plan.slow_down(axes, all, speed) || !plan.run(plan.slowed, axes, speed)) throw_no_trajectory();
  plan.slowness.from = plan.slowing_time;
}

void JointLeg::throw_no_trajectory() const {
  throw NonFatalError(
      ErrorCode::invalid_argument,
      "no trajectory to the target (Ruckig result " + std::to_string(static_cast<int>(plan_->result)) + ")",
      {robot_->task().process_name(), robot_->name(), 0, robot_->state().tick});
}

double JointLeg::duration() const noexcept {
  return plan_->slowing_time + plan_->trajectory.get_duration() / plan_->pace;
}

DesiredState JointLeg::at(double time) const {
  if (over(time)) return DesiredState::resting_at(target_);
  const Plan& plan = *plan_;
  JointValues position{}, velocity{}, acceleration{};
  double pace = 1;
  if (time < plan.slowing_time) {
    plan.slowing.at_time(time, position, velocity, acceleration);
  } else {
    pace = plan.pace;
    plan.trajectory.at_time(pace * (time - plan.slowing_time), position, velocity, acceleration);
  }
  const Eigen::Index joints = target_.size();
  return {Eigen::Map<const Eigen::VectorXd>(position.data(), joints),
          pace * Eigen::Map<const Eigen::VectorXd>(velocity.data(), joints),
          pace * pace * Eigen::Map<const Eigen::VectorXd>(acceleration.data(), joints)};
}

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
