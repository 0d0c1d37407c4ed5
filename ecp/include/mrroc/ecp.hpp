#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "links/exchange/robot_responder.hpp"
#include "mrroc/behaviours.hpp"
#include "mrroc/conditions/digital_input.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/conditions/operator_trigger.hpp"
#include "mrroc/conditions/touching.hpp"
#include "mrroc/conditions/travelled.hpp"
#include "mrroc/generators/complying.hpp"
#include "mrroc/generators/corrected.hpp"
#include "mrroc/generators/force_control.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/generators/joint_line.hpp"
#include "mrroc/generators/tool_velocity.hpp"
#include "mrroc/move.hpp"
#include "process/task_process.hpp"

namespace mrroc::ecp {

class SuperiorCommands;

/// c_l: the program of one effector. Derive, declare the robot and the sensors as members built from `*this`, write
/// `run()`, or behaviours (`on<Pick>(...)` in the constructor), or both, and end the file with `MRROC_ECP(YourTask)`.
/// The ECP starts it when the MP commands it: `run()` by `start("arm")`, a behaviour by `start("arm", Pick{...})`.
/// While it runs, commands of MP-level Moves to this robot are refused (`busy`), but in a Move with a `Coordinated`
/// generator, in which the MP takes part; when none runs, the ECP is transparent: it relays them to the EDP.
class Task : public process::TaskProcess {
 public:
  /// Called by the framework only.
  Task();
  ~Task() override;

  /// The program; empty by default. An exception ends it, as it ends a behaviour: an Error is reported to the MP with
  /// its class; `Stopped` is a stop.
  virtual void run() {}
  /// Runs the program or behaviour of the last `start`. When a stop or an error leaves the robot in motion, the robot
  /// comes to rest before the exception is rethrown: the next start begins from rest.
  void run_started();

  /// This ECP's own robot when `requested` is empty; no other robot exists in an ECP (NonFatalError).
  std::string robot_name(const std::string& requested) const override;

  /// Relays all waiting commands of the MP to the EDP. Between runs.
  void relay();

  /// c_0 as this ECP sees it, for `Coordinated` generators: Complying{superior(), arm}.
  Superior& superior() noexcept { return superior_; }

 protected:
  /// Sets the action for a start by the MP with a B, a type declared with MRROC_MESSAGE. In the constructor.
  template <MessageType B, class Handler>
  void on(Handler handler) {
    behaviours_.on<B>(std::move(handler));
  }
  /// Sends a message to the MP, whose task gets it with `take<M>("arm")`. Does not wait.
  template <MessageType M>
  void tell(const M& message) {
    Behaviours::tells<M>();
    tell_parcel(pack(message));
  }
  /// The oldest message of this type that the MP has sent to this program since its start and that was not taken.
  /// Neither waits nor allocates: for a generator or a condition too.
  template <MessageType M>
  std::optional<M> take() {
    Message parcel;
    return mailbox().take(label_of<M>(), parcel) ? std::optional<M>(unpack<M>(parcel)) : std::nullopt;
  }
  /// Whether there is such a message. For conditions: When{"corrected", [this] { return heard<Correction>(); }}.
  template <MessageType M>
  bool heard() noexcept {
    return mailbox().has(label_of<M>());
  }

  std::string robot_topic(const std::string& name) const override;
  std::string robot_peer(const std::string& name) const override;
  void poll_others() override;

 private:
  void tell_parcel(const Message& parcel);
  /// Holds the robot until it rests or reports why it cannot.
  void come_to_rest();

  Behaviours behaviours_;
  links::RobotResponder mp_;
  RobotLink* edp_;
  links::RobotRequester* requester_;  ///< `edp_`, when no injected faults are in between: messages pass as they came
  std::unique_ptr<SuperiorCommands> superior_commands_;
  Superior superior_;
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
