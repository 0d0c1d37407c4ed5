#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "clock/clock.hpp"
#include "clock/wall/monotonic.hpp"
#include "mrroc/generator.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

inline constexpr double kPeakSpeed = 0.1;  // rad/s, of `Cycloid`

/// A task with one robot behind the given link, without operator and observer.
class OneRobotTask : public Task {
 public:
  OneRobotTask(clock::Clock& clock, RobotLink& link) : clock_(clock), link_(link) {}
  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string& requested) const override { return requested; }
  RobotLink& robot_link(const std::string&, const std::string&) override { return link_; }
  SensorLink& sensor_link(const std::string& name, const std::string&, bool&) override {
    throw NonFatalError(ErrorCode::invalid_argument, "sensor '" + name + "'");
  }
  double servo_period() const noexcept override { return clock_.period(); }
  Tick tick() const noexcept override { return clock_.tick(); }
  double wall_seconds() const noexcept override { return clock_.wall_seconds(); }
  void sleep_until(Tick tick) override { clock_.wait(tick); }
  OperatorRequest operator_request() noexcept override { return OperatorRequest::none; }
  bool take_trigger() noexcept override { return false; }
  StepObserver* observer() noexcept override { return nullptr; }

 private:
  clock::Clock& clock_;
  RobotLink& link_;
  std::string name_ = "ecp";
};

/// All joints along a cycloid of `steps` steps, s = t/D - sin(2 pi t/D) / 2 pi: from rest to rest without a jump of the
/// acceleration. Records the time of every step.
class Cycloid : public Generator {
 public:
  Cycloid(Robot& robot, int steps, double direction, std::vector<std::int64_t>& stamps)
      : Generator("cycloid"),
        robot_(robot),
        duration_(steps * robot.step_duration()),
        // neighbours against each other: sums of the arms' angles drive the motors
        distance_(JointVector{{1.0, 1.0, -1.0, 1.0, -1.0, 1.0}} * (direction * kPeakSpeed * duration_ / 2)),
        stamps_(stamps) {}

  void start() override { from_ = robot_.known_state().desired_joints; }

  void next_state() override {
    stamps_.push_back(clock::monotonic_ns());
    ++step_;
    const double phase = 2 * std::numbers::pi * std::min(1.0, step_ * robot_.step_duration() / duration_);
    const double rate = 1 / duration_;
    RobotCommand& command = robot_.command();
    command.kind = CommandKind::joint;
    command.joints = from_ + distance_ * ((phase - std::sin(phase)) / (2 * std::numbers::pi));
    command.joint_velocity = distance_ * (rate * (1 - std::cos(phase)));
    command.joint_acceleration = distance_ * (rate * rate * 2 * std::numbers::pi * std::sin(phase));
  }

 private:
  Robot& robot_;
  double duration_;
  JointVector distance_;
  JointVector from_;
  int step_ = 0;
  std::vector<std::int64_t>& stamps_;
};

}  // namespace mrroc
