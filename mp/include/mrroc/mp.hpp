#pragma once

#include <functional>
#include <map>
#include <memory>

#include "links/task_superior.hpp"
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

namespace mrroc::mp {

/// c_0: the program that coordinates all effectors. Derive, declare robots and sensors as members built from `*this`
/// (`Irb6 left{*this, "left"};`), write `run()`, and end the file with `MRROC_MP(YourTask)`.
///
/// Tight cooperation: `Move` and `Wait` over several robots; their ECPs are transparent. Loose: `start` ECPs, each runs
/// its own program, and `wait_for_all`; the error of a started ECP that fails meanwhile is thrown by the MP's own Move
/// or Wait, once, with its class. The operator's pause, resume, trigger and stop reach the MP's own instructions and
/// every ECP that it has started.
class Task : public process::TaskProcess {
 public:
  /// Called by the framework only.
  Task();

  virtual void run() = 0;

  /// Starts the program of the ECP of robot `name`. Throws NonFatalError when there is none.
  void start(const std::string& name);
  /// Starts the program of every ECP.
  void start_all();
  /// Stops the program of the ECP of robot `name`, as the operator's stop does, and waits until it has ended and its
  /// robot rests; does nothing when it does not run. When it failed instead, its error is thrown here. Throws
  /// NonFatalError when there is none, Stopped when the operator stops meanwhile.
  void stop(const std::string& name);
  /// Waits until every started ECP has ended. When one fails, the others are stopped and its error is thrown here, with
  /// its class and where it arose; when the operator stops, all are stopped and Stopped is thrown.
  void wait_for_all();

  std::string robot_name(const std::string& requested) const override;
  OperatorRequest operator_request() override;

  /// Handshakes with the ECPs and with everything the task uses.
  void connect();

 protected:
  std::string robot_topic(const std::string& name) const override;
  std::string robot_peer(const std::string& name) const override { return name; }
  void poll_others() override;
  void on_superior_command(const links::TaskCommand& command) override;

 private:
  struct Ecp {
    std::unique_ptr<links::TaskSuperior> link;
    bool running = false;
    std::uint64_t started_by = 0;  // number of the last start command
    links::TaskStatus status;
  };
  Ecp& ecp(const std::string& name, const char* asked);
  [[noreturn]] static void rethrow(Ecp& failed);
  void wait_for_running();
  void command_running(links::TaskCommandKind kind);
  bool any_running() const noexcept;
  Ecp* failed() noexcept;

  std::map<std::string, Ecp> ecps_;
  bool stopped_ = false;
};

using TaskFactory = std::function<std::unique_ptr<Task>()>;

/// main() of an MP.
int run(int argc, char** argv, const TaskFactory& factory);

}  // namespace mrroc::mp

/// Makes an MP program out of a task class.
#define MRROC_MP(TaskClass)                                                          \
  int main(int argc, char** argv) {                                                  \
    return mrroc::mp::run(argc, argv, [] { return std::make_unique<TaskClass>(); }); \
  }
