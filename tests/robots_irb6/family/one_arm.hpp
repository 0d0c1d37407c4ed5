#pragma once

#include <string>

#include "mrroc/robot.hpp"
#include "mrroc/task.hpp"
#include "robots_irb6/family/robot_under_test.hpp"

namespace mrroc {

/// Answers every command at once with the joints that it asked for.
class EchoLink : public RobotLink {
 public:
  void send(const RobotCommand& command) override { joints_ = command.joints; }
  void receive(RobotState& state) override { state.joints = joints_; }

 private:
  JointVector joints_;
};

/// A process with one robot, "arm", of the type under test.
class OneArm : public Task {
 public:
  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string& requested) const override { return requested.empty() ? "arm" : requested; }
  RobotLink& robot_link(const std::string& name, const std::string& type) override {
    if (name != "arm" || type != robot_under_test().name)
      throw NonFatalError(ErrorCode::invalid_argument, "no " + type + " " + name);
    return link_;
  }
  SensorLink& sensor_link(const std::string& name, const std::string&, bool&) override {
    throw NonFatalError(ErrorCode::invalid_argument, "no sensor " + name);
  }
  double servo_period() const noexcept override { return 0.002; }
  Tick tick() const noexcept override { return 0; }
  double wall_seconds() const noexcept override { return 0; }
  void sleep_until(Tick) override {}
  OperatorRequest operator_request() noexcept override { return OperatorRequest::none; }
  bool take_trigger() noexcept override { return false; }
  StepObserver* observer() noexcept override { return nullptr; }

 private:
  std::string name_ = "arm";
  EchoLink link_;
};

}  // namespace mrroc
