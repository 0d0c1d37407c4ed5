#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "language/fake_model.hpp"
#include "mrroc/ecp.hpp"
#include "mrroc/robots/irb6.hpp"
#include "mrroc/sensors/force_torque.hpp"

using namespace mrroc;

namespace {

/// One macrostep, with the command that a function writes.
class Once : public Generator {
 public:
  Once(Robot& robot, std::function<void(RobotCommand&)> write)
      : Generator("Once"), robot_(robot), write_(std::move(write)) {}
  bool terminal_condition() override { return done_; }
  void next_state() override {
    write_(robot_.command());
    done_ = true;
  }

 private:
  Robot& robot_;
  std::function<void(RobotCommand&)> write_;
  bool done_ = false;
};

/// Makes one error, selected by the name of its deployment.
class Faulty : public ecp::Task {
  Irb6 arm{*this};

  void run() override {
    const std::map<std::string, std::function<void()>> kinds{
        {"sensor", [this] { ForceTorque(*this, "ghost"); }},
        {"sensor_type", [this] { ForceTorque(*this, "gate"); }},
        {"robot_type", [this] { Robot(*this, "", {std::make_shared<fakes::FakeModel>(6)}); }},
        {"macrostep", [this] { arm.set_macrostep(0, 1); }},
        {"target",
         [this] {
           Move({arm}, {}, JointLine{arm, Irb6::tool_down(5, 0, 0)});
         }},
        {"pose",
         [this] { command([](RobotCommand& c) { c.kind = CommandKind::pose, c.pose = Irb6::tool_down(5, 0, 0); }); }},
        {"nan", [this] { to_joint_2(std::numeric_limits<double>::quiet_NaN()); }},
        {"infinite", [this] { to_joint_2(std::numeric_limits<double>::infinity()); }},
        {"limit", [this] { to_joint_2(3.0); }},
        {"fast", [this] { to_joint_2(arm.parameters().home[2] + 0.1); }},
        {"axes",
         [this] { command([](RobotCommand& c) { c.kind = CommandKind::joint, c.joints = JointVector::Zero(5); }); }},
        {"steps", [this] { command([](RobotCommand& c) { c.motion_steps = 0; }); }},
        {"many_steps", [this] { command([](RobotCommand& c) { c.motion_steps = kMaxMotionSteps + 1; }); }},
        {"reply", [this] { command([](RobotCommand& c) { c.reply_step = 12; }); }},
        {"caught", [this] { recover(); }},
        {"exception", [] { throw std::runtime_error("a task's own exception"); }},
        {"hardware", [] { throw HardwareError(ErrorCode::drive_fault, "thrown by the task"); }},
        {"crash", [] { std::abort(); }},
        {"hold",
         [this] {
           Wait({arm}, {}, When{"never", [] { return false; }});
         }},
        {"trigger", [this] { Wait({arm}, {}, OperatorTrigger{*this}); }},
        {"zero_time",
         [this] {
           for (;;) Wait({arm}, {}, When{"always", [] { return true; }});
         }},
        {"endless", [] {
           // a computation without end; the thread sanitizer sees signals only where the program calls the system's
           // library
           volatile char digit = '0';
           for (char text[16];;) {
             std::snprintf(text, sizeof text, "%c", digit);
             digit = text[0];
           }
         }}};
    const std::string& kind = process().deployment().name;
    Wait({arm}, {}, ElapsedSteps{1});
    const JointVector before = arm.state().desired_joints;
    try {
      kinds.at(kind)();
    } catch (const NonFatalError&) {
      // a refused command does not move the robot
      Wait({arm}, {}, ElapsedSteps{2});
      if (arm.state().desired_joints != before) throw SystemError(ErrorCode::invalid_argument, "the robot has moved");
      throw;
    }
  }

  void command(std::function<void(RobotCommand&)> write) {
    Once generator(arm, std::move(write));
    Move({arm}, {}, generator);
  }

  void to_joint_2(double position) {
    command([this, position](RobotCommand& command) {
      command.kind = CommandKind::joint;
      command.joints = arm.parameters().home;
      command.joints[2] = position;
    });
  }

  /// The task may catch a non-fatal error; the robot still accepts commands.
  void recover() {
    try {
      Move({arm}, {}, JointLine{arm, Irb6::tool_down(5, 0, 0)});
    } catch (const NonFatalError& error) {
      if (error.code() != ErrorCode::out_of_workspace) throw;
    }
    to_joint_2(arm.parameters().home[2]);
    const Outcome end = Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.75, 0, 0.01)});
    if (end.steps == 0) throw SystemError(ErrorCode::invalid_argument, "the robot has not moved");
  }
};

}  // namespace

MRROC_ECP(Faulty)
