#include <gtest/gtest.h>

#include "mrroc/robots/polycrank.hpp"
#include "mrroc/task.hpp"
#include "robots_polycrank/polycrank_fixture.hpp"

namespace mrroc {
namespace {

/// Answers every command at once with the joints that it asked for.
class EchoLink : public RobotLink {
 public:
  void send(const RobotCommand& command) override { joints_ = command.joints; }
  void receive(RobotState& state) override { state.joints = joints_; }

 private:
  JointVector joints_;
};

/// A process with one robot, "arm" of type polycrank.
class OneArm : public Task {
 public:
  const std::string& process_name() const noexcept override { return name_; }
  std::string robot_name(const std::string& requested) const override { return requested.empty() ? "arm" : requested; }
  RobotLink& robot_link(const std::string& name, const std::string& type) override {
    if (name != "arm" || type != "polycrank")
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

TEST(PolycrankClass, TakesItsProcessesRobotAndTheInstalledModel) {
  OneArm process;
  Polycrank arm(process);
  EXPECT_EQ(arm.name(), "arm");
  EXPECT_EQ(arm.parameters().type, "polycrank");
  const JointVector home = arm.parameters().home;
  EXPECT_EQ(arm.kinematics().direct(home).matrix(), ToolKinematics(polycrank_model()).direct(home).matrix());
  arm.command().joints = home;
  arm.send();
  arm.receive();
  EXPECT_EQ(arm.state().joints, home);
}

TEST(PolycrankClass, RefusesANameThatTheDeploymentDoesNotHave) {
  OneArm process;
  EXPECT_THROW(Polycrank(process, "leg"), NonFatalError);
}

}  // namespace
}  // namespace mrroc
