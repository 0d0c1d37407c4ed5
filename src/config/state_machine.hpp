#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "config/deployment.hpp"
#include "config/entries/program_behaviours.hpp"
#include "mrroc/parcel.hpp"

namespace mrroc::config {

/// The name of the state that ends a task with success.
inline constexpr const char* kEndState = "end";

/// One state of a task: it starts behaviours, or asks the operator, and then continues to another.
struct State {
  struct Start {
    std::string robot;
    Message behaviour;      ///< without label: the program of the robot's ECP
    std::string arguments;  ///< "x = 0.6, y = 0.1", for people
  };
  std::string name;
  std::vector<Start> starts;  ///< in file order
  bool any = false;           ///< continues when the first has ended, not all; the others are stopped
  std::string question;       ///< to answer by yes or no; may be empty
  std::string next, yes, no;  ///< states to continue to
  std::string on_error;       ///< after a non-fatal error of a started robot; empty: the task fails with it
  /// States to continue to when a started robot sends a message with this label; the running behaviours are stopped.
  std::vector<std::pair<std::string, std::string>> on;
  std::int64_t at_most = 0;  ///< maximum number of entries; 0: unlimited
  std::string afterwards;    ///< state to continue to after that number of entries
};

/// A task as states and transitions, read from a file (docs/reference/state-machines.md). The stock MP runs it when the
/// deployment names one.
struct StateMachine {
  std::filesystem::path file;
  std::string first;
  std::vector<State> states;  ///< in file order
  const State& state(const std::string& name) const;
};

/// Reads and validates: every named robot, behaviour, argument, message and state exists and has the expected type,
/// every state can be reached, and the end can be reached from each. `programs`: the behaviours of each robot's ECP.
/// Throws ConfigurationError with file, line, key, value and what was expected. Configuration time only.
StateMachine load_state_machine(const std::filesystem::path& file, const Deployment& deployment,
                                const ProgramsByRobot& programs);

/// The states and transitions as a graph in the language DOT of Graphviz.
std::string to_dot(const StateMachine& machine);

}  // namespace mrroc::config
