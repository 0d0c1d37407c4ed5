#pragma once

#include <set>
#include <vector>

#include "language/script.hpp"

/// The calls of a run of Move or Wait, sorted into exchanges.
namespace mrroc::fakes {

/// One exchange with robots and sensors, in the order of the calls. `step` is that of the resulting state.
struct Exchange {
  std::vector<Call> calls;
  bool is_get = false;
  bool is_pause = false;
  std::uint64_t step = 0;
};

inline bool is_exchange(Action action) {
  return action == Action::send || action == Action::receive || action == Action::request ||
         action == Action::collect || action == Action::latest || action == Action::sleep;
}

/// Splits the log at the calls outside an exchange. The first exchange is the GET; one that follows the operator's
/// answer with no evaluation in between is a pause.
inline std::vector<Exchange> exchanges(const RunRecord& run) {
  std::vector<Exchange> found;
  bool open = false;
  bool evaluated = false;
  std::uint64_t step = 0;
  for (const Call& call : run.calls) {
    if (call.action == Action::observe && call.device == "last") break;  // then moving robots hold until they rest
    if (call.action == Action::observe) continue;
    if (!is_exchange(call.action)) {
      open = false;
      if (call.action == Action::ask_operator) evaluated = false;
      if (call.action == Action::evaluate || call.action == Action::terminal_condition) evaluated = true;
      continue;
    }
    if (!open) {
      found.push_back({});
      found.back().is_get = found.size() == 1;
      found.back().is_pause = !found.back().is_get && !evaluated;
      if (!found.back().is_get && evaluated) ++step;
      found.back().step = step;
      open = true;
    }
    found.back().calls.push_back(call);
  }
  return found;
}

inline std::vector<std::size_t> places(const Exchange& exchange, std::set<Action> actions) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < exchange.calls.size(); ++i) {
    if (actions.contains(exchange.calls[i].action)) found.push_back(i);
  }
  return found;
}

inline std::uint64_t count(const RunRecord& run, Action action) {
  std::uint64_t n = 0;
  for (const Call& call : run.calls) n += call.action == action ? 1u : 0u;
  return n;
}

}  // namespace mrroc::fakes
