#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "mrroc/robot_command.hpp"

namespace mrroc::fakes {

/// A call that a fake received.
enum class Action {
  send,                ///< robot: a command
  receive,             ///< robot: its reply
  request,             ///< interactive sensor: a reading
  bias,                ///< interactive sensor: a bias
  collect,             ///< interactive sensor: the reply
  latest,              ///< non-interactive sensor: the newest reading
  sleep,               ///< task
  ask_operator,        ///< task
  observe,             ///< observer
  start_condition,     ///< leaf of a condition
  evaluate,            ///< leaf of a condition
  start_generator,     ///< generator
  resume_generator,    ///< generator
  terminal_condition,  ///< generator
  next_state           ///< generator
};

/// One call: its receiver and the relevant arguments; the others keep their defaults.
struct Call {
  Action action{};
  std::string device;                     ///< robot, sensor or leaf; empty for task and generator
  Tick tick = 0;                          ///< start tick, measure_at, tick slept until
  CommandKind kind = CommandKind::query;  ///< of a command
  int motion_steps = 0;
  int reply_step = 0;
  double value = 0;  ///< first joint of a command

  friend bool operator==(const Call&, const Call&) = default;
};

/// "send arm hold N10 v8 @20"
inline std::ostream& operator<<(std::ostream& out, const Call& call) {
  static const char* const actions[] = {"send",
                                        "receive",
                                        "request",
                                        "bias",
                                        "collect",
                                        "latest",
                                        "sleep",
                                        "ask operator",
                                        "observe",
                                        "start condition",
                                        "evaluate",
                                        "start generator",
                                        "resume generator",
                                        "terminal condition",
                                        "next state"};
  static const char* const kinds[] = {"query", "hold", "joint", "pose"};
  out << actions[static_cast<int>(call.action)];
  if (!call.device.empty()) out << " " << call.device;
  if (call.action == Action::send) {
    out << " " << kinds[static_cast<int>(call.kind)] << " N" << call.motion_steps << " v" << call.reply_step << " ["
        << call.value << "]";
  }
  return out << "@" << call.tick;
}

/// All calls to all fakes of one test, in order.
class CallLog {
 public:
  void add(Call call) {
    if (recording) calls.push_back(std::move(call));
  }
  std::vector<Call> calls;
  bool recording = true;
};

}  // namespace mrroc::fakes
