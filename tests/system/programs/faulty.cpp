#include <cstdlib>
#include <limits>
#include <string>

#include "mrroc/ecp.hpp"
#include "mrroc/robots/irb6.hpp"
#include "mrroc/sensors/force_torque.hpp"

using namespace mrroc;

namespace {

/// Writes what a lambda writes, for one step.
template <class Write>
class Once : public Generator {
 public:
  Once(Robot& robot, Write write) : Generator("Once"), robot_(robot), write_(write) {}
  bool terminal_condition() override { return done_; }
  void next_state() override {
    write_(robot_.command());
    done_ = true;
  }

 private:
  Robot& robot_;
  Write write_;
  bool done_ = false;
};

/// Does one thing wrong, as the name of its deployment says.
class Faulty : public ecp::Task {
  Irb6 arm{*this};

  void run() override {
    const std::string kind = process().deployment().name;
    if (kind == "sensor") ForceTorque ghost(*this, "ghost");
    if (kind == "pose") Move({arm}, {}, JointLine{arm, Irb6::tool_down(5, 0, 0)});
    if (kind == "commanded_pose") {
      command([](RobotCommand& command) {
        command.kind = CommandKind::pose;
        command.pose = Irb6::tool_down(5, 0, 0);
      });
    }
    if (kind == "nan") {
      command([this](RobotCommand& command) {
        command.kind = CommandKind::joint;
        command.joints = arm.parameters().home;
        command.joints[2] = std::numeric_limits<double>::quiet_NaN();
      });
    }
    if (kind == "steps") command([](RobotCommand& command) { command.motion_steps = 0; });
    if (kind == "reply") command([](RobotCommand& command) { command.reply_step = 12; });
    if (kind == "caught") recover();
    if (kind == "crash") std::abort();
  }

  template <class Write>
  void command(Write write) {
    Once<Write> generator(arm, write);
    Move({arm}, {}, generator);
  }

  /// A non-fatal error is the task's to catch; the robot still takes commands.
  void recover() {
    try {
      Move({arm}, {}, JointLine{arm, Irb6::tool_down(5, 0, 0)});
    } catch (const NonFatalError& error) {
      if (error.code() != ErrorCode::out_of_workspace) throw;
    }
    Move({arm}, {}, JointLine{arm, Irb6::tool_down(0.75, 0, 0.01)});
  }
};

}  // namespace

MRROC_ECP(Faulty)
