#pragma once

#include <functional>
#include <vector>

#include "language/free_flyer.hpp"

namespace mrroc::fakes {

/// A task with one robot, a FreeModel that follows force motions tick by tick according to docs/explanation/force.md,
/// with the law alone: no limits, no drives. `felt` is the wrench of the environment on the tool, in tool axes, as a
/// function of the tool's pose and twist (tool axes). Poses and joints are executed exactly; a `hold` stops at once.
/// Replies are sent at tick v of N.
class ForceFlyer : public FakeTask, private RobotLink {
 public:
  using Environment = std::function<Wrench(const Pose& pose, const Twist& twist)>;

  explicit ForceFlyer(const Pose& start, Environment environment, std::uint16_t motion_steps = 10,
                      std::uint16_t reply_step = 8)
      : felt(std::move(environment)), pose(start) {
    arm = std::make_unique<Robot>(*this, "arm", RobotModels{model_});
    arm->set_macrostep(motion_steps, reply_step);
    log.recording = false;
  }
  RobotLink& robot_link(const std::string&, const std::string&) override { return *this; }

  Environment felt;
  Pose pose;                                         ///< present pose of the tool
  Twist twist = Twist::Zero();                       ///< its twist, in tool axes
  std::vector<RobotCommand> commands;                ///< all but queries
  std::function<void(Tick, const Wrench&)> on_tick;  ///< after each tick of a force motion
  std::unique_ptr<Robot> arm;

 private:
  void send(const RobotCommand& command) override {
    command_ = command;
    if (command.kind != CommandKind::query) commands.push_back(command);
  }
  void receive(RobotState& reply) override {
    if (command_.kind == CommandKind::query) return fill(reply);
    go_to(end_);  // the remainder of the previous macrostep
    active_ = command_;
    start_ = std::max({active_.start_tick, end_, time.tick});
    end_ = start_ + active_.motion_steps;
    now_ = start_;
    go_to(start_ + active_.reply_step);
    time.reach(now_);
    fill(reply);
  }
  void go_to(Tick tick) {
    for (; now_ < tick; ++now_) step();
  }
  void step() {
    if (active_.kind == CommandKind::force && now_ < end_) {
      const double dt = servo_period();
      const Wrench wrench = felt(pose, twist);
      const ForceLaw& law = active_.force;
      for (Eigen::Index i = 0; i < 6; ++i) {
        const auto behaviour = law.behaviour[static_cast<std::size_t>(i)];
        const double b = behaviour == AxisBehaviour::unguarded ? 0 : law.admittance[i];
        const double m = behaviour == AxisBehaviour::unguarded ? 0 : law.inertia[i];
        const double wanted = behaviour == AxisBehaviour::contact ? law.wrench[i] : 0;
        const double v = behaviour == AxisBehaviour::contact ? 0 : active_.twist[i];
        const double moved = twist[i] * dt;
        twist[i] = ((b * (wrench[i] - wanted) + v) * dt * dt + b * m * moved) / (dt + b * m) / dt;
      }
      pose = pose * exp_twist(twist * dt);
      if (on_tick) on_tick(now_ + 1, wrench);
    } else {
      twist.setZero();
      if (active_.kind == CommandKind::pose) pose = active_.pose;
      if (active_.kind == CommandKind::joint) pose = model_->flange(active_.joints);
    }
  }
  void fill(RobotState& reply) const {
    RobotState state;
    state.synchronised = state.enabled = true;
    state.tick = std::max(now_, time.tick);
    state.macrostep_start = start_;
    state.desired_tick = active_.kind == CommandKind::force ? state.tick : std::max(end_, state.tick);
    model_->inverse(pose, {}, state.desired_joints);
    state.joints = state.desired_joints;
    state.pose = state.desired_pose = pose;
    state.desired_velocity = rotate_twist(pose.linear(), twist);
    state.desired_acceleration = JointVector::Zero(6);
    state.wrench = felt(pose, twist);
    reply = state;
  }

  std::shared_ptr<FreeModel> model_ = std::make_shared<FreeModel>();
  RobotCommand command_, active_;
  Tick start_ = 0, end_ = 0, now_ = 0;
};

/// An elastic, frictionless surface: a tip (the origin of the tool frame) at depth d is pushed out with `stiffness` d
/// along the outward normal. `depth` returns d, `normal` the normal, both in the base frame.
struct SpringSurface {
  double stiffness = 2000;  ///< N/m
  std::function<double(const Eigen::Vector3d&)> depth;
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> normal;

  Wrench operator()(const Pose& tool, const Twist&) const {
    const double d = std::max(0.0, depth(tool.translation()));
    Wrench wrench = Wrench::Zero();
    wrench.head<3>() = tool.linear().transpose() * (stiffness * d * normal(tool.translation()));
    return wrench;
  }
};

/// The half space below the plane through `point` with the outward normal `normal`.
inline SpringSurface plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double stiffness = 2000) {
  const Eigen::Vector3d n = normal.normalized();
  return {stiffness, [=](const Eigen::Vector3d& p) { return (point - p).dot(n); },
          [=](const Eigen::Vector3d&) { return n; }};
}

/// The inside of a ball.
inline SpringSurface ball(const Eigen::Vector3d& centre, double radius, double stiffness = 2000) {
  return {stiffness, [=](const Eigen::Vector3d& p) { return radius - (p - centre).norm(); },
          [=](const Eigen::Vector3d& p) { return Eigen::Vector3d{(p - centre).normalized()}; }};
}

}  // namespace mrroc::fakes
