#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/rigid_motion.hpp"
#include "geometry/rotation_rates.hpp"
#include "language/fakes.hpp"
#include "language/property.hpp"
#include "language/random_values.hpp"
#include "mrroc/move.hpp"

namespace mrroc::fakes {

inline double distance(const Pose& a, const Pose& b) { return (a.translation() - b.translation()).norm(); }
inline double angle(const Pose& a, const Pose& b) {
  return rotation_vector(a.linear() * b.linear().transpose()).norm();
}

/// A tool with unlimited poses: axes 0..2 are its position, 3..5 its rotation vector, on the branch nearest to the
/// previous one. Position limits +-`room`; velocity, acceleration and jerk limits `fast`, 10 and 100 times that.
class WideModel : public FakeModel {
 public:
  WideModel(double room, double fast) : FakeModel(6), parameters_(FakeModel::parameters()) {
    for (AxisParameters& axis : parameters_.axes) {
      axis.position_min = -room;
      axis.position_max = room;
      axis.velocity_max = fast;
      axis.acceleration_max = 10 * fast;
      axis.jerk_max = 100 * fast;
      axis.motor_min = -1e9;
      axis.motor_max = 1e9;
    }
  }
  const RobotParameters& parameters() const noexcept override { return parameters_; }
  Pose flange(const JointVector& joints) const noexcept override {
    Pose pose = Pose::Identity();
    pose.translation() = joints.head<3>();
    pose.linear() = exp_rotation(joints.tail<3>());
    return pose;
  }
  ErrorCode inverse(const Pose& pose, const JointVector& near, JointVector& joints) const noexcept override {
    Eigen::Vector3d vector = rotation_vector(pose.linear());
    if (near.size() == 6) {
      const Eigen::Vector3d last = near.tail<3>();
      const double turn = 2 * std::numbers::pi;
      // without its own axis it continues about the present one
      const Eigen::Vector3d axis = vector.norm() > 1e-6 ? vector.normalized() : last.normalized();
      vector += turn * std::round((last - vector).dot(axis) / turn) * axis;
    }
    joints.resize(6);
    joints << pose.translation(), vector;
    return ErrorCode::none;
  }

 private:
  RobotParameters parameters_;
};

/// A task with one robot, a WideModel that executes every command of joints or a pose exactly. After a `hold` in
/// motion, or a late command, each joint rolls on for some ms before it rests, and the robot leaves its path.
class PathArm : public FakeTask, private RobotLink {
 public:
  explicit PathArm(const Pose& start, std::uint16_t motion_steps = 1, double room = 100, double fast = 1000)
      : model_(std::make_shared<WideModel>(room, fast)) {
    arm = std::make_unique<Robot>(*this, "arm", RobotModels{model_});
    arm->set_macrostep(motion_steps, motion_steps);
    state.synchronised = state.enabled = true;
    state.tick = state.desired_tick = time.tick;
    model_->inverse(start, {}, state.desired_joints);
    rest();
    state.desired_pose = state.pose = start;
  }
  RobotLink& robot_link(const std::string&, const std::string&) override { return *this; }

  double dt() const { return arm->step_duration(); }
  void move(Generator& generator) { ending = Move({*arm}, {}, generator).ending; }
  void move(Generator&& generator) { move(generator); }
  /// Within a property: at this step the operator pauses for a while, or the command is late. Returns which.
  enum class Interruption { pause, late_command };
  Interruption interrupt_at(int step) {
    if (pick(0, 1) == 1) {
      late_at_ = static_cast<std::size_t>(step);
      return Interruption::late_command;
    }
    requests.assign(static_cast<std::size_t>(step), OperatorRequest::none);
    requests.insert(requests.end(), 3, OperatorRequest::pause);
    return Interruption::pause;
  }
  /// Initial motion: joints per second.
  void roll(const JointVector& velocity) { state.desired_velocity = velocity; }

  RobotState state;
  Ending ending = Ending::condition;
  std::vector<RobotCommand> commands;  ///< all of a motion
  std::vector<JointVector> joints;     ///< after each
  std::size_t resumed_at = 0;          ///< number of the first command after an interruption
  JointVector rested_at;               ///< position of the robot after the interruption
  std::unique_ptr<Robot> arm;

 private:
  static constexpr double kRollOn = 0.05;  // s

  void rest() { state.desired_velocity = state.desired_acceleration = JointVector::Zero(6); }
  /// The joints roll on for different times.
  void roll_on() {
    const Eigen::Array<double, 6, 1> times = Eigen::Array<double, 6, 1>::LinSpaced(6, 0.5 * kRollOn, kRollOn);
    state.desired_joints.array() += times * state.desired_velocity.array();
    rest();
    rested_at = state.desired_joints;
    resumed_at = commands.size();
  }
  void send(const RobotCommand& command) override {
    command_ = command;
    if (command.kind == CommandKind::joint || command.kind == CommandKind::pose) commands.push_back(command);
  }
  void receive(RobotState& reply) override {
    if (command_.kind != CommandKind::query) {
      const bool late = command_.kind != CommandKind::hold && commands.size() == late_at_;
      if (late) {
        ++state.late_commands;
        roll_on();
      } else if (command_.kind == CommandKind::pose) {
        model_->inverse(command_.pose, JointVector(state.desired_joints), state.desired_joints);
        const Turning turning = vector_rates_of(state.desired_joints.tail<3>(),
                                                {command_.twist.tail<3>(), command_.twist_acceleration.tail<3>()});
        state.desired_velocity << command_.twist.head<3>(), turning.velocity;
        state.desired_acceleration << command_.twist_acceleration.head<3>(), turning.rate;
      } else if (command_.kind == CommandKind::joint) {
        rest();
        state.desired_joints = command_.joints;
        if (command_.joint_velocity.size() > 0) state.desired_velocity = command_.joint_velocity;
        if (command_.joint_acceleration.size() > 0) state.desired_acceleration = command_.joint_acceleration;
      } else {
        roll_on();
      }
      if (command_.kind != CommandKind::hold) joints.push_back(state.desired_joints);
      state.desired_pose = model_->flange(state.desired_joints);
      state.macrostep_start = std::max({command_.start_tick, state.desired_tick, time.tick});
      state.tick = state.desired_tick = state.macrostep_start + command_.motion_steps;
      state.pose = state.desired_pose;
      state.joints = state.desired_joints;
      time.reach(state.tick);
    }
    reply = state;
  }

  std::shared_ptr<WideModel> model_;
  RobotCommand command_;
  std::size_t late_at_ = 0;
};

/// The laws of every path of the tool that is commanded tick by tick: speeds and accelerations within the limits, the
/// jerk within 10 / s times the acceleration, twists that are the poses' derivatives, at rest at the end. Each command
/// from number `first` on is one of a pose.
template <class Limits>
void assert_tool_motion(const PathArm& task, const Limits& limits, std::size_t first = 0) {
  const double dt = task.dt();
  constexpr double kBeyond = 1 + 1e-6;
  for (std::size_t k = first; k < task.commands.size(); ++k) {
    const RobotCommand& now = task.commands[k];
    RC_ASSERT(now.kind == CommandKind::pose);
    RC_ASSERT(is_rigid(now.pose));
    const Twist rate = now.twist_acceleration;
    RC_ASSERT(now.twist.head<3>().norm() <= limits.speed * kBeyond);
    RC_ASSERT(now.twist.tail<3>().norm() <= limits.angular_speed * kBeyond);
    RC_ASSERT(rate.head<3>().norm() <= limits.acceleration * kBeyond);
    RC_ASSERT(rate.tail<3>().norm() <= limits.angular_acceleration * kBeyond);
    if (k == first) continue;
    const RobotCommand& before = task.commands[k - 1];
    const Twist jerk = (now.twist_acceleration - before.twist_acceleration) / dt;
    RC_ASSERT(jerk.head<3>().norm() <= 10 * limits.acceleration * 1.001);
    RC_ASSERT(jerk.tail<3>().norm() <= 10 * limits.angular_acceleration * 1.001);
    // trapezoidal rule: the error is dt^2 / 12 times the third derivative
    Twist way;
    way << now.pose.translation() - before.pose.translation(),
        rotation_vector(now.pose.linear() * before.pose.linear().transpose());
    const double error = dt * dt * 10 * (limits.acceleration + limits.angular_acceleration) + 1e-9 / dt;
    RC_ASSERT((way / dt - 0.5 * (now.twist + before.twist)).norm() < error);
    const Twist change = (now.twist - before.twist) / dt;
    RC_ASSERT((change - 0.5 * (now.twist_acceleration + before.twist_acceleration)).norm() <
              dt * 10 * (limits.acceleration + limits.angular_acceleration));
  }
  RC_ASSERT(task.commands.back().twist.isZero(0));
  RC_ASSERT(task.commands.back().twist_acceleration.isZero(0));
}

}  // namespace mrroc::fakes
