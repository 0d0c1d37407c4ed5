#pragma once

#include <functional>
#include <memory>

#include "links/robot_responder.hpp"
#include "mrroc/conditions/digital_input.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/operator_trigger.hpp"
#include "mrroc/conditions/touching.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/generators/force_control.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/tool_velocity.hpp"
#include "mrroc/move.hpp"
#include "process/task_process.hpp"

namespace mrroc::ecp {

/// c_l: the program of one effector. Derive, declare the robot and the sensors as members built from `*this`, write
/// `run()`, and end the file with `MRROC_ECP(YourTask)`. The ECP starts it when the MP says so. While it runs, commands
/// of MP-level Moves to this robot are refused (`busy`); when none runs, the ECP is transparent: it relays them to the
/// EDP.
class Task : public process::TaskProcess {
 public:
  /// Called by the framework only.
  Task();

  /// The program. What it throws ends it: an Error is reported to the MP with its class; `Stopped` is a stop.
  virtual void run() = 0;

  /// This ECP's own robot when `requested` is empty; no other robot exists in an ECP (NonFatalError).
  std::string robot_name(const std::string& requested) const override;

  /// Relays the MP's commands to the EDP until none is left. Between runs.
  void relay();

 protected:
  std::string robot_topic(const std::string& name) const override;
  std::string robot_peer(const std::string& name) const override;
  void poll_others() override;

 private:
  links::RobotResponder mp_;
  RobotLink* edp_;
  RobotCommand command_;
  RobotState state_;
};

using TaskFactory = std::function<std::unique_ptr<Task>()>;

/// main() of an ECP.
int run(int argc, char** argv, const TaskFactory& factory);

}  // namespace mrroc::ecp

/// Makes an ECP program out of a task class.
#define MRROC_ECP(TaskClass)                                                          \
  int main(int argc, char** argv) {                                                   \
    return mrroc::ecp::run(argc, argv, [] { return std::make_unique<TaskClass>(); }); \
  }
