#pragma once

#include <string>
#include <utility>

#include "mrroc/errors.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

/// A process with one robot, whose link keeps the last command in `sent` and answers with `state`.
class OneRobotTask : public Task, private RobotLink {
 public:
  /// `parameters`: the file that the deployment names; empty: that of its type.
  OneRobotTask(std::string name, std::string type, std::filesystem::path parameters = {})
      : name_(std::move(name)), type_(std::move(type)), parameters_(std::move(parameters)) {}

  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string& requested) const override { return requested.empty() ? name_ : requested; }
  std::filesystem::path robot_parameters(const std::string&, const std::string& type) const override {
    return type.empty() || type == type_ ? parameters_ : std::filesystem::path();
  }
  RobotLink& robot_link(const std::string& name, const std::string& type) override {
    if (name != name_ || type != type_) throw NonFatalError(ErrorCode::invalid_argument, "no " + type + " " + name);
    return *this;
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

  RobotCommand sent;
  RobotState state;

 private:
  void send(const RobotCommand& command) override { sent = command; }
  void receive(RobotState& answer) override { answer = state; }

  std::string name_, type_;
  std::filesystem::path parameters_;
};

}  // namespace mrroc
