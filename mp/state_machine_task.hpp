#pragma once

#include <map>
#include <string>

#include "config/state_machine.hpp"
#include "mrroc/mp.hpp"

namespace mrroc::mp {

/// Runs the state machine that the deployment names, from its first state to the end.
class StateMachineTask : public Task {
 public:
  /// Throws ConfigurationError when the file is wrong.
  StateMachineTask()
      : machine_(config::load_state_machine(process().deployment().mp.states, process().deployment(),
                                            config::read_programs(process().arguments().behaviours))) {}
  void run() override;

 private:
  /// Does what the state says; returns the state to continue to.
  std::string enter(const config::State& state);
  std::string run_behaviours(const config::State& state);
  /// The state to continue to now; empty: not yet.
  std::string transition(const config::State& state);
  /// The state itself, or those that follow it when it has been entered often enough.
  std::string not_exhausted(std::string name) const;

  config::StateMachine machine_;
  std::map<std::string, std::int64_t> entered_;
};

}  // namespace mrroc::mp
