#include "mp/state_machine_task.hpp"

#include <algorithm>

namespace mrroc::mp {

void StateMachineTask::run() {
  for (std::string name = not_exhausted(machine_.first); name != config::kEndState;) {
    ++entered_[name];
    tell_operator("state " + name);
    name = not_exhausted(enter(machine_.state(name)));
  }
}

std::string StateMachineTask::not_exhausted(std::string name) const {
  for (std::size_t i = 0; i <= machine_.states.size(); ++i) {
    if (name == config::kEndState) return name;
    const config::State& state = machine_.state(name);
    const auto entered = entered_.find(name);
    if (state.at_most == 0 || entered == entered_.end() || entered->second < state.at_most) return name;
    name = state.afterwards;
  }
  throw NonFatalError(ErrorCode::task_failed,
                      "the states that follow '" + name + "' have all been entered often enough");
}

std::string StateMachineTask::enter(const config::State& state) {
  if (!state.question.empty()) return ask_yes_no(state.question) ? state.yes : state.no;
  std::string next;
  try {
    next = run_behaviours(state);
  } catch (const NonFatalError& error) {
    if (state.on_error.empty()) throw;
    tell_operator(std::string{error.what()}.substr(0, 127));
    next = state.on_error;
  }
  for (const config::State::Start& start : state.starts) stop(start.robot);
  return next;
}

std::string StateMachineTask::run_behaviours(const config::State& state) {
  for (const config::State::Start& start : state.starts) start_with(start.robot, start.behaviour);
  std::string next;
  wait_until([&] { return !(next = transition(state)).empty(); });
  return next;
}

std::string StateMachineTask::transition(const config::State& state) {
  Message parcel;
  for (const auto& [label, next] : state.on)
    for (const config::State::Start& start : state.starts)
      if (take_parcel(start.robot, label, parcel)) return next;
  for (const config::State::Start& start : state.starts) forget_messages(start.robot);
  const auto ended = [this](const config::State::Start& start) { return !running(start.robot); };
  const bool done = state.any ? std::any_of(state.starts.begin(), state.starts.end(), ended)
                              : std::all_of(state.starts.begin(), state.starts.end(), ended);
  return done ? state.next : "";
}

}  // namespace mrroc::mp
