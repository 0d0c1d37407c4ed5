#pragma once

#include <netinet/in.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "cli/run/watch/heartbeat.hpp"
#include "clock/emergency_stop.hpp"
#include "clock/wall/peer_clock.hpp"

namespace mrroc::cli {

/// Statistics of a link, for reports.
struct LinkFigures {
  std::uint64_t sent = 0;
  std::uint64_t heard = 0;
  std::uint64_t refused = 0;         ///< datagrams that were old beats or not beats of the peer
  std::int64_t longest_silence = 0;  ///< ns, since `watch()`
  std::int64_t drift_ns = 0;         ///< PeerClock::worst_drift_ns
  std::int64_t certain_drift_ns = 0;
};

/// One end of the link between the runner and another host. A thread sends a beat in each tenth of the timeout, at
/// least every 50 ms (until the start every 4 ms, to estimate the clock soon), receives the peer's, estimates its clock
/// from them and detects when they stop. UDP, because TCP would keep repeating itself after a cut; every beat is
/// sealed. The runner's beats also carry its emergency stop: the other end's follows within a tenth of the timeout,
/// later when beats are lost; when all are, the link is lost. The main thread constructs it; any thread may query it.
class HostLink {
 public:
  /// Binds a port of `own` among those that a DDS domain leaves free: 7600 + 250 domain to 7649 + 250 domain.
  /// `emergency_stop`: of this host; it must outlive the link. Throws std::runtime_error when there is no port.
  HostLink(in_addr own, int domain, const HeartbeatKey& key, bool is_runner, double timeout,
           clock::EmergencyStop& emergency_stop);
  ~HostLink();
  HostLink(const HostLink&) = delete;
  HostLink& operator=(const HostLink&) = delete;

  int port() const noexcept { return port_; }
  /// Begins to send beats to the peer's end.
  void start(in_addr peer, int port);
  /// From now on silence counts as a loss, and the peer's clock may not drift.
  void watch();

  /// True when no beat has come for the timeout since `watch()`; then it stays true.
  bool lost() const noexcept { return lost_.load(); }
  /// Becomes readable when the link is lost.
  int event_fd() const noexcept { return event_; }
  /// Whether the peer's emergency stop has been pressed and reset as often as the runner's; asked at the runner.
  bool peer_follows() const noexcept {
    return peer_presses_ >= emergency_stop_.presses() && peer_resets_ >= emergency_stop_.resets();
  }
  /// The peer's clock; nothing during the first 128 beats.
  std::optional<clock::ClockOffset> offset() const;
  LinkFigures figures() const;
  /// What the system refused to the thread; empty when it refused nothing.
  std::string warning() const;

 private:
  void run();
  void listen();
  void take(const Heartbeat& beat, std::int64_t now);
  void send(std::int64_t now);
  void check_silence(std::int64_t now);

  const HeartbeatKey key_;
  const bool is_runner_;
  const std::int64_t timeout_;  // ns
  clock::EmergencyStop& emergency_stop_;
  int socket_ = -1;
  int event_ = -1;
  int port_ = 0;
  sockaddr_in peer_{};

  std::uint64_t peer_sequence_ = 0;  // the thread's, up to `thread_`
  std::int64_t peer_sent_ = 0;
  std::int64_t heard_at_ = 0;

  mutable std::mutex mutex_;  // of the members that the thread writes
  clock::PeerClock clock_;
  LinkFigures figures_;
  std::string warning_;
  std::int64_t watched_since_ = 0;  // 0: not watched
  std::atomic<bool> lost_{false};
  std::atomic<std::uint32_t> peer_presses_{0}, peer_resets_{0};
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace mrroc::cli
