#pragma once

#include "edp/rig.hpp"

namespace mrroc::edp {

/// A wall at x >= `wall` that pushes back along -x; the test sets the sensor's other values.
class WallSensor : public ForceSensor {
 public:
  const Pose& mount() const noexcept override { return mount_; }
  WrenchReading read(Tick, const Pose* flange) noexcept override {
    WrenchReading reading;
    reading.error = error;
    reading.wrench = extra;
    if (flange != nullptr) reading.wrench[0] -= stiffness * std::max(0.0, flange->translation().x() - wall);
    last_ = reading.wrench;
    reading.wrench -= zero_;
    return reading;
  }
  void bias() noexcept override { zero_ = last_; }
  void carry(const Load& load) noexcept override { carried = load; }

  double wall = 0.1;        // m
  double stiffness = 1000;  // N/m
  ErrorCode error = ErrorCode::none;
  Wrench extra = Wrench::Zero();
  Load carried;

 private:
  Pose mount_ = Pose::Identity();
  Wrench last_ = Wrench::Zero(), zero_ = Wrench::Zero();
};

/// A robot with a force sensor before a wall.
template <class Model>
struct ForceRig : Rig<Model> {
  explicit ForceRig(const ForceLimits& limits = (ForceLimits() << 65, 65, 130, 5, 5, 5).finished())
      : Rig<Model>(false) {
    this->servo.use_force_sensor(sensor, limits);
    this->effector.use_force_sensor(sensor.mount());
    this->effector.enable(true);
    this->run(2);
  }

  /// Sends and runs until the reply has left.
  RobotState exchange(const RobotCommand& command) {
    this->replies.clear();
    if (this->send(command)) return this->answer.state;
    for (int i = 0; i < 20'000 && this->replies.empty(); ++i) this->tick();
    return this->replies.at(0).state;
  }
  /// Repeats the same command, like a generator; returns the last state, or the first with an error.
  RobotState repeat(const RobotCommand& command, int times) {
    RobotState state;
    for (int i = 0; i < times && state.error.error_class == ErrorClass::none; ++i) state = exchange(command);
    return state;
  }

  WallSensor sensor;
};

using GantryBeforeWall = ForceRig<Gantry>;

inline bool well(const RobotState& state) { return state.error.error_class == ErrorClass::none; }

/// Presses along x with `newtons` (or, without them, moves compliantly at `speed`), free in the other axes.
inline RobotCommand force_command(double newtons, double speed = 0) {
  RobotCommand command;
  command.kind = CommandKind::force;
  command.motion_steps = 10;
  command.reply_step = 8;
  command.twist[0] = speed;
  if (newtons != 0)
    command.force.contact(0, -newtons);
  else
    command.force.guarded(0);
  command.force.admittance[0] = 0.01;
  command.force.inertia[0] = 1;
  return command;
}

}  // namespace mrroc::edp
