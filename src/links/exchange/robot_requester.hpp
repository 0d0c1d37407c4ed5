#pragma once

#include "links/exchange/requester.hpp"
#include "links/exchange/robot_responder.hpp"
#include "mrroc/robot_link.hpp"

namespace mrroc::links {

/// The link of a `Robot` to its EDP, or of an MP to an ECP: topics `<prefix>/command` and `<prefix>/state`. Errors and
/// threads: see `Requester`.
class RobotRequester final : public RobotLink {
 public:
  static constexpr Tick kTimeout = 500;
  /// Longest duration of a robot's synchronisation or recovery, and until its drives are on at the start.
  static constexpr Tick kLongest = 150'000;

  /// `prefix`: "<deployment>/<robot>"; `peer`: the other process's name, for errors; `timeout`: maximum lateness of a
  /// reply, ticks.
  RobotRequester(Domain& domain, clock::Clock& clock, const std::string& prefix, std::string peer,
                 Tick timeout = kTimeout);

  /// Hand-shake with the responder, about `timeout` s at most; before the clock starts.
  void connect(double timeout) { exchange_.connect(timeout); }

  /// The reply is due at the command's tick v, counted from the present, from `start_tick` or from the end of the
  /// macrostep under way according to the last state, whichever comes last; `timeout` ticks later it is missed. The
  /// first reply, and those to `synchronise` and `recover`, may come kLongest later: the link still notices when the
  /// peer is gone.
  void send(const RobotCommand& command) override { send(command, timeout_); }
  void send(const RobotCommand& command, Tick timeout);
  /// As `send`, of the command that `responder` has taken last and returned as `command`, as it came.
  void forward(RobotResponder& responder, const RobotCommand& command);
  void receive(RobotState& state) override;

  bool peer_alive() const noexcept { return exchange_.peer_alive(); }
  std::uint64_t stale_replies() const noexcept { return exchange_.stale_replies(); }
  std::uint64_t malformed_replies() const noexcept { return exchange_.malformed_replies(); }

 private:
  friend class RobotResponder;
  Tick due(const RobotCommand& command) const;

  clock::Clock& clock_;
  const Tick timeout_;
  Requester<RobotCommand, RobotState> exchange_;
  Tick busy_until_ = 0;  // the last state's desired_tick
  bool answered_ = false;
};

}  // namespace mrroc::links
