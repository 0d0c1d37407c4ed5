#pragma once

#include <functional>
#include <limits>

#include "geometry/rigid_motion.hpp"
#include "language/fakes.hpp"

namespace mrroc::fakes {

/// A tool with unlimited poses: axes 0..2 are its position, 3..5 its rotation vector; their velocities are the tool's
/// twist in base axes. With range `unlimited` it has no position limits.
class FreeModel : public FakeModel {
 public:
  enum class Range { limited, unlimited };
  explicit FreeModel(Range range = Range::limited) : FakeModel(6) {
    if (range == Range::limited) return;
    for (AxisParameters& axis : parameters_.axes) {
      axis.position_max = axis.motor_max = std::numeric_limits<double>::infinity();
      axis.position_min = axis.motor_min = -axis.position_max;
    }
  }
  Pose flange(const JointVector& joints) const noexcept override {
    Pose pose = Pose::Identity();
    pose.translation() = joints.head<3>();
    pose.linear() = exp_rotation(joints.tail<3>());
    return pose;
  }
  ErrorCode inverse(const Pose& pose, const JointVector&, JointVector& joints) const noexcept override {
    joints.resize(6);
    joints << pose.translation(), rotation_vector(pose.linear());
    return ErrorCode::none;
  }
  Jacobian jacobian(const JointVector&, const Eigen::Vector3d&) const noexcept override {
    return Jacobian::Identity(6, 6);
  }
};

/// A task with one robot, a FreeModel that executes every command of a pose or of joints exactly. Its measured state is
/// the desired one, as if v = N, or that of the previous macrostep (`delayed`).
class FreeFlyer : public FakeTask, private RobotLink {
 public:
  explicit FreeFlyer(const Pose& start, std::uint16_t motion_steps = 10) {
    arm = std::make_unique<Robot>(*this, "arm", RobotModels{model_});
    arm->set_macrostep(motion_steps, motion_steps);
    state.synchronised = state.enabled = true;
    state.desired_velocity = state.desired_acceleration = JointVector::Zero(6);
    state.tick = state.desired_tick = time.tick;
    place(start);
    state.pose = start;
  }
  void place(const Pose& pose) {
    state.desired_pose = pose;
    model_->inverse(pose, {}, state.desired_joints);
  }
  RobotLink& robot_link(const std::string&, const std::string&) override { return *this; }

  RobotState state;
  bool delayed = false;                     ///< measured is the pose of the previous macrostep
  std::function<Wrench(const Pose&)> felt;  ///< the wrench at a measured pose; empty: `state.wrench`
  std::vector<RobotCommand> commands;       ///< all of a motion
  std::unique_ptr<Robot> arm;

 private:
  void send(const RobotCommand& command) override {
    command_ = command;
    if (command.kind != CommandKind::query) commands.push_back(command);
  }
  void receive(RobotState& reply) override {
    if (command_.kind != CommandKind::query) {
      const Pose before = state.desired_pose;
      if (command_.kind == CommandKind::pose) {
        place(command_.pose);
        state.desired_velocity = command_.twist;
      } else if (command_.kind == CommandKind::joint) {
        state.desired_joints = command_.joints;
        state.desired_pose = model_->flange(command_.joints);
        state.desired_velocity = JointVector::Zero(6);
        if (command_.joint_velocity.size() > 0) state.desired_velocity = command_.joint_velocity;
      } else {
        state.desired_velocity.setZero();
      }
      state.macrostep_start = std::max({command_.start_tick, state.desired_tick, time.tick});
      state.tick = state.desired_tick = state.macrostep_start + command_.motion_steps;
      state.pose = delayed ? before : state.desired_pose;
      state.joints = state.desired_joints;
      time.reach(state.tick);
    }
    if (felt) state.wrench = felt(state.pose);
    reply = state;
  }

  std::shared_ptr<FreeModel> model_ = std::make_shared<FreeModel>();
  RobotCommand command_;
};

}  // namespace mrroc::fakes
