#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "links/exchange/task_superior.hpp"
#include "mrroc/conditions/digital_input.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/operator_trigger.hpp"
#include "mrroc/conditions/touching.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/generators/force_control.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/tool_velocity.hpp"
#include "mrroc/message.hpp"
#include "mrroc/move.hpp"
#include "process/task_process.hpp"

namespace mrroc::mp {

/// c_0: the program that coordinates all effectors. Derive, declare robots and sensors as members built from `*this`
/// (`Irb6 left{*this, "left"};`), write `run()`, and end the file with `MRROC_MP(YourTask)`.
///
/// Tight cooperation: `Move` and `Wait` over several robots; their ECPs are transparent. Loose: `start` ECPs, each runs
/// its own program or one of its behaviours, and `wait_for_all` or `wait_for_any`; messages between ECPs pass through
/// the MP (`take`, `tell`). Both at once: `concurrently`. When a started ECP fails, its error is thrown once, with its
/// class, by the call in which the MP waits, also a Move. The operator's pause, resume, trigger, end-motion and stop
/// reach the MP's own instructions and every ECP that it has started.
class Task : public process::TaskProcess {
 public:
  /// Called by the framework only.
  Task();

  virtual void run() = 0;

  /// Starts the program of the ECP of robot `name`; while the task is paused it waits first. Throws NonFatalError:
  /// invalid_argument when there is no such robot, busy when its ECP still runs.
  void start(const std::string& name) { start_with(name, {}); }
  /// Starts its behaviour for this message, in the same manner. A missing behaviour is an error of the ECP.
  template <MessageType B>
  void start(const std::string& name, const B& behaviour) {
    start_with(name, pack(behaviour));
  }
  /// Starts it and waits until it has ended, as wait_for_all({name}) does.
  template <MessageType B>
  void perform(const std::string& name, const B& behaviour) {
    start(name, behaviour);
    wait_for_all({name});
  }
  /// Starts the program of every ECP.
  void start_all();
  /// Whether the program or behaviour started in the ECP of robot `name` still runs. In a Move: .until(When{"belt has
  /// ended", [this] { return !running("belt"); }}).
  bool running(const std::string& name);
  /// Ends the Move or Wait under way in the ECP of robot `name`, as if its condition had held; does nothing when
  /// the ECP runs nothing. Does not wait.
  void end_motion(const std::string& name);
  /// Stops the program of the ECP of robot `name`, as the operator's stop does, and waits until it has ended and its
  /// robot rests; does nothing when it does not run. When it failed instead, its error is thrown here. Throws
  /// NonFatalError when the robot does not exist, Stopped when the operator stops meanwhile.
  void stop(const std::string& name);
  /// Waits until every started ECP has ended. When one fails, the others are stopped and its error is thrown here, with
  /// its class and where it arose; when the operator stops, all are stopped and Stopped is thrown.
  void wait_for_all();
  /// Waits until those of them that were started have ended. When an ECP fails, its error is thrown here, and the
  /// others continue. Throws NonFatalError when there is no such robot, Stopped.
  void wait_for_all(const std::vector<std::string>& names);
  /// Waits until one of them has ended, or none runs, and returns its name: the first in the list of those that do not
  /// run. Throws as `wait_for_all`.
  std::string wait_for_any(const std::vector<std::string>& names);

  /// Sends a message to the program in the ECP of robot `name`, which gets it with `take<M>()`; lost when none runs.
  /// Does not wait.
  template <MessageType M>
  void tell(const std::string& name, const M& message) {
    tell_parcel(name, pack(message));
  }
  /// The oldest message of this type that the ECP of robot `name` has sent since its start and that was not taken;
  /// also when it has ended since. Neither waits nor allocates.
  template <MessageType M>
  std::optional<M> take(const std::string& name) {
    Message parcel;
    return take_parcel(name, label_of<M>(), parcel) ? std::optional<M>(unpack<M>(parcel)) : std::nullopt;
  }
  /// Whether there is such a message. For conditions.
  template <MessageType M>
  bool heard(const std::string& name) {
    return heard_label(name, label_of<M>());
  }

  /// Runs these parts of the task in parallel until all have ended: each may Move and Wait, ask, start and wait for
  /// ECPs. They take turns: a part continues until it waits for a reply, a tick or the operator. Two parts must not
  /// use one robot, or one interactive sensor, at the same time (NonFatalError(busy)). When one throws, the others are
  /// stopped at their next step, and the error is thrown here. Not within a part (NonFatalError(invalid_argument)).
  void concurrently(const std::vector<std::function<void()>>& parts);

  std::string robot_name(const std::string& requested) const override;
  OperatorRequest operator_request() override;

  /// Connects to the ECPs and to everything that the task uses.
  void connect();

 protected:
  // the same for messages whose types are read from a file
  void start_with(const std::string& name, const Message& behaviour);
  bool take_parcel(const std::string& name, std::string_view label, Message& parcel);
  void forget_messages(const std::string& name);

  std::string robot_topic(const std::string& name) const override;
  std::string robot_peer(const std::string& name) const override { return name; }
  void poll_others() override;
  void on_superior_command(const links::TaskCommand& command) override;

 private:
  struct Ecp {
    std::unique_ptr<links::TaskSuperior> link;
    bool running = false;
    bool asked_to_stop = false;
    std::uint64_t started_by = 0;  // number of the last start command
    links::TaskStatus status;
    process::Mailbox mailbox;
  };
  void tell_parcel(const std::string& name, const Message& parcel);
  bool heard_label(const std::string& name, std::string_view label);
  Ecp& ecp(const std::string& name, const char* asked);
  [[noreturn]] static void rethrow(Ecp& failed);
  /// Records the state of an ECP. One that ends by a stop that this MP did not request was ended from outside: it has
  /// failed.
  static void note(const std::string& name, Ecp& ecp, links::TaskStatus status);
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
