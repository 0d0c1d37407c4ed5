#pragma once

#include <map>
#include <string>

#include "config/state_machine.hpp"
#include "mrroc/mp.hpp"

namespace mrroc::mp {

/// Runs the state machine that the deployment names, from its first state to the end.
class StateMachineTask : public Task {
 public:
  /// Throws ConfigurationError when the file is invalid.
  StateMachineTask()
      : machine_(config::load_state_machine(process().deployment().mp.states, process().deployment(),
                                            config::read_programs(process().arguments().behaviours))) {}
  void run() override;

 private:
  /// Executes the state; returns the next state.
  std::string enter(const config::State& state);
  std::string run_behaviours(const config::State& state);
  /// The next state; empty when it is not decided yet.
  std::string transition(const config::State& state);
  /// The state itself, or a following one when it has been entered often enough.
  std::string not_exhausted(std::string name) const;

  config::StateMachine machine_;
  std::map<std::string, std::int64_t> entered_;
};

}  // namespace mrroc::mp
