#pragma once

#include <gtest/gtest.h>

#include "drivers/mujoco/mujoco_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "sim/simulation.hpp"

namespace mrroc {

/// The EDP core of one robot of a simulated world, without its process: effector, servo, driver.
class SimulatedEdp {
 public:
  static constexpr double kPeriod = 0.002;

  SimulatedEdp(std::shared_ptr<const RobotModel> model, world::WorldMemory& memory, std::size_t slot)
      : model_(std::move(model)), hardware_(*model_, memory, slot, edp::MujocoHardware::Timing::lockstep) {}

  /// Switches the drives on, at the tick 0 that the world has published.
  void start() {
    effector_.enable(true);
    tick(0);
  }
  void tick(Tick now) {
    servo_.tick(now);
    while (effector_.poll(reply_)) {
      EXPECT_EQ(reply_.state.error.error_class, ErrorClass::none) << reply_.state.error.detail.view();
    }
  }
  /// Moves the only axis to `position`, arriving with `velocity`, in `steps` ticks; the reply comes at the end.
  void go(double position, std::uint16_t steps, double velocity = 0) {
    RobotCommand command;
    command.kind = CommandKind::joint;
    command.joints = JointVector::Constant(1, position);
    command.joint_velocity = JointVector::Constant(1, velocity);
    send(command, steps);
  }
  /// Changes the speed of the only axis to `velocity` as fast as its limits allow and keeps it, `steps` ticks in all.
  void keep(double velocity, std::uint16_t steps) {
    RobotCommand command;
    command.kind = CommandKind::joint_velocity;
    command.joint_velocity = JointVector::Constant(1, velocity);
    send(command, steps);
  }
  void enable(bool on) { effector_.enable(on); }
  const edp::Snapshot& snapshot() const { return servo_.snapshot(); }

 private:
  void send(RobotCommand& command, std::uint16_t steps) {
    command.motion_steps = steps;
    command.reply_step = steps;
    edp::Reply refusal;
    EXPECT_FALSE(effector_.accept(command, ++number_, refusal)) << refusal.state.error.detail.view();
  }

  std::shared_ptr<const RobotModel> model_;
  edp::MujocoHardware hardware_;
  edp::ServoChannel channel_;
  edp::ModelSet models_{*model_};
  edp::Servo servo_{models_, hardware_, kPeriod, channel_};
  edp::Effector effector_{models_, kPeriod, channel_};
  edp::Reply reply_;
  std::uint64_t number_ = 0;
};

}  // namespace mrroc
