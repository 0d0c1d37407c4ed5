#pragma once

#include "links/exchange/responder.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::links {

class RobotRequester;

/// The other end of `RobotRequester`, in the EDP or in a transparent ECP. The participant's thread calls it.
class RobotResponder {
 public:
  /// s; an older command is dropped. For tests: the processes use the deployment's `heartbeat_timeout`
  /// (docs/decisions/0013-one-patience.md).
  static constexpr double kMaxAge = 0.25;

  RobotResponder(Domain& domain, clock::Clock& clock, const std::string& prefix, double max_age = kMaxAge);

  /// The newest command not yet taken, if it is fresh; false when there is none. Does not wait, lock or allocate.
  bool take(RobotCommand& command, std::uint64_t& sequence) { return exchange_.take(command, sequence); }

  /// Whether the command taken last was sent at most `max_age` s ago.
  bool fresh(double max_age) const noexcept { return exchange_.fresh(max_age); }

  /// Answers the command taken last; false, and nothing sent, for one that has been overtaken. Not from a servo tick.
  bool reply(const RobotState& state, std::uint64_t sequence) { return exchange_.reply(state, sequence); }

  /// As `reply`, with the state that `requester` has received last, as it came.
  bool forward(RobotRequester& requester, std::uint64_t sequence);

  bool peer_alive() const noexcept { return exchange_.peer_alive(); }
  /// Dropped commands, by reason.
  ReaderCounters counters() const noexcept { return exchange_.counters(); }

 private:
  friend class RobotRequester;
  Responder<RobotCommand, RobotState> exchange_;
};

}  // namespace mrroc::links
