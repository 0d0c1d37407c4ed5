#include <gtest/gtest.h>

#include "fixture.hpp"
#include "mrroc/robots/serial_parallel.hpp"
#include "mrroc/task.hpp"

namespace mrroc {
namespace {

/// A link on which nothing comes.
class SilentLink : public RobotLink {
 public:
  void send(const RobotCommand&) override {}
  void receive(RobotState&) override {}
};

/// A process with one robot, "machine" of type serial_parallel.
class OneMachine : public Task {
 public:
  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string& requested) const override { return requested.empty() ? name_ : requested; }
  RobotLink& robot_link(const std::string& name, const std::string& type) override {
    if (name != "machine" || type != "serial_parallel") {
      throw NonFatalError(ErrorCode::invalid_argument, "no " + type + " " + name);
    }
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
  std::string name_ = "machine";
  SilentLink link_;
};

TEST(SerialParallelClass, TakesItsProcessesRobotAndTheInstalledModel) {
  OneMachine process;
  SerialParallel machine_of_task(process);
  EXPECT_EQ(machine_of_task.name(), "machine");
  const JointVector home = machine_of_task.parameters().home;
  EXPECT_EQ(machine_of_task.models().front()->flange(home).matrix(), machine().flange(home).matrix());
  EXPECT_THROW(SerialParallel(process, "leg"), NonFatalError);
}

}  // namespace
}  // namespace mrroc
