#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drivers/loopback/loopback_hardware.hpp"
#include "edp/command/effector.hpp"
#include "edp/servo/servo.hpp"
#include "generators/cell_task.hpp"
#include "language/limits.hpp"

namespace mrroc::test {

/// A task process around several robots, each with its EDP core (effector and servo) and the plant model of its drives,
/// without processes and transport. Waiting for a reply advances the time. Every set-point of every tick is checked
/// against the limits.
class LoopbackCell : public CellTask {
 public:
  /// The robots are named robot0, robot1, ...
  explicit LoopbackCell(const std::vector<std::shared_ptr<const RobotModel>>& models) : LoopbackCell(models, nullptr) {}
  /// The first robot has a force sensor with limits of 50 N and 5 N m.
  LoopbackCell(const std::vector<std::shared_ptr<const RobotModel>>& models, edp::ForceSensor* sensor) {
    for (const auto& model : models) {
      cores_.push_back(std::make_unique<Core>(*this, model));
      cores_.back()->servo.use_group_stops(group_stops_, cores_.size() - 1);
    }
    cores_[0]->servo.use_emergency_stop(emergency_stop_);
    if (sensor != nullptr)
      cores_[0]->servo.use_force_sensor(*sensor, (edp::ForceLimits() << 50, 50, 50, 5, 5, 5).finished());
    for (int i = 0; i < 10; ++i) step();
    for (std::size_t i = 0; i < models.size(); ++i)
      robots_.push_back(std::make_unique<Robot>(*this, "robot" + std::to_string(i), RobotModels{models[i]}));
  }

  Robot& robot(std::size_t i = 0) { return *robots_[i]; }
  const edp::Snapshot& seen(std::size_t i = 0) const { return cores_[i]->servo.snapshot(); }

  RobotLink& robot_link(const std::string& name, const std::string&) override {
    return *cores_[static_cast<std::size_t>(std::stoi(name.substr(5)))];
  }
  bool each_on_its_own = false;        ///< robots without a successor do not brake in step
  bool unknown_to_each_other = false;  ///< a robot that stops alone does not stop the others
  /// The first robot stops alone, as fast as it can.
  void press_emergency_stop() noexcept { emergency_stop_.press(); }
  /// The first robot is switched off by order.
  void switch_off() noexcept { cores_[0]->effector.enable(false); }
  /// Called after every tick.
  std::function<void()> on_tick;

  Tick tick() const noexcept override { return now_; }
  void sleep_until(Tick tick) override {
    while (now_ < tick) step();
  }

 private:
  struct Core : RobotLink {
    Core(LoopbackCell& cell_, std::shared_ptr<const RobotModel> model_)
        : cell(&cell_), model(std::move(model_)), hardware(*model, kPeriod), models(*model) {
      effector.enable(true);
    }
    void tick(Tick now) {
      servo.tick(now);
      edp::Reply reply;
      while (effector.poll(reply)) {
        answer = reply.state;
        answered = true;
      }
      const edp::Snapshot& seen = servo.snapshot();
      ASSERT_TRUE(seen.fault.code == ErrorCode::none || cell->emergency_stop_.presses() > 0);
      JointVector motors;
      ASSERT_EQ(model->joints_to_motors(seen.desired.position, motors), ErrorCode::none);
      for (std::size_t i = 0; i < model->parameters().axes.size(); ++i) {
        const AxisParameters& axis = model->parameters().axes[i];
        const auto row = static_cast<Eigen::Index>(i);
        ASSERT_TRUE(is_within(seen.desired.position[row], axis.position_min, axis.position_max)) << axis.name;
        ASSERT_TRUE(is_within(motors[row], axis.motor_min, axis.motor_max)) << axis.name;
        ASSERT_FALSE(exceeds(seen.desired.velocity[row], axis.velocity_max)) << axis.name;
        ASSERT_FALSE(exceeds(seen.desired.acceleration[row], axis.acceleration_max)) << axis.name;
      }
    }
    void send(const RobotCommand& command) override {
      RobotCommand received = command;
      if (cell->each_on_its_own) received.stop = {};
      if (cell->unknown_to_each_other) received.stop.group = 0;
      edp::Reply reply;
      answered = effector.accept(received, ++number, reply);
      if (answered) answer = reply.state;
    }
    void receive(RobotState& state) override {
      while (!answered) cell->step();
      state = answer;
    }

    LoopbackCell* cell;
    std::shared_ptr<const RobotModel> model;
    edp::LoopbackHardware hardware;
    edp::ServoChannel hand_over;
    edp::ModelSet models;
    edp::Servo servo{models, hardware, kPeriod, hand_over};
    edp::Effector effector{models, kPeriod, hand_over};
    std::uint64_t number = 0;
    RobotState answer;
    bool answered = false;
  };

  void step() {
    for (const auto& core : cores_) core->tick(now_);
    ++now_;
    if (on_tick) on_tick();
  }

  Tick now_ = 0;
  clock::GroupStops group_stops_;
  clock::EmergencyStop emergency_stop_;
  std::vector<std::unique_ptr<Core>> cores_;
  std::vector<std::unique_ptr<Robot>> robots_;
};

}  // namespace mrroc::test
