#pragma once

#include <cstdint>
#include <optional>

namespace mrroc::clock {

/// One exchange with another machine, ns: `sent` and `received` are its two ends on this machine's CLOCK_MONOTONIC,
/// `peer` is the time on the peer's at which the answer left, `held` how long the peer had had the question by then.
struct RoundTrip {
  std::int64_t sent = 0;
  std::int64_t received = 0;
  std::int64_t peer = 0;
  std::int64_t held = 0;
};

/// Where a peer's CLOCK_MONOTONIC is: its reading minus this machine's at the same moment, ns, and how far off that may
/// be at most. The bound is half the time on the way, whatever the share of either direction.
struct ClockOffset {
  std::int64_t ns = 0;
  std::int64_t error_ns = 0;
};

/// The clock of another machine, learnt from round trips: of each window of `kWindow` of them the one that was on the
/// way for the shortest time counts, for what makes the others longer is queues. The best offset is kept, but an
/// old one gives way to a newer: clocks drift apart. What windows after `keep()` say of the drift is compared with it.
/// One thread; it allocates nothing.
class PeerClock {
 public:
  static constexpr int kWindow = 128;
  /// By how much of the time two clocks drift apart when no one steers them.
  static constexpr double kUnsteered = 1e-4;

  /// Takes in one round trip; one that cannot be (shorter on the way than nothing) is left out.
  void add(const RoundTrip& trip) noexcept;

  /// The best so far; nothing before the first window is full.
  std::optional<ClockOffset> offset() const noexcept { return first_; }
  /// From now on the offset stays: what moves away from it is drift.
  void keep() noexcept { kept_ = true; }

  /// Since `keep()`: the largest change of the offset that any window has shown, ns, and the largest that is certain,
  /// both errors taken off.
  std::int64_t worst_drift_ns() const noexcept { return worst_drift_; }
  std::int64_t certain_drift_ns() const noexcept { return certain_drift_; }
  /// Of all windows since `keep()`, the shortest time on the way of the slowest one, ns.
  std::int64_t worst_trip_ns() const noexcept { return worst_trip_; }

 private:
  void close_window(std::int64_t now) noexcept;

  std::optional<ClockOffset> first_;
  std::int64_t first_at_ = 0;  // on this machine's clock
  ClockOffset best_;           // of the window
  int in_window_ = 0;
  bool kept_ = false;
  std::int64_t worst_drift_ = 0;
  std::int64_t certain_drift_ = 0;
  std::int64_t worst_trip_ = 0;
};

}  // namespace mrroc::clock
