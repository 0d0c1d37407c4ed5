#pragma once

#include <cstdint>
#include <optional>

namespace mrroc::clock {

/// One exchange with another machine, ns: `sent` and `received` are its two ends on this machine's CLOCK_MONOTONIC,
/// `peer` is the time on the peer's at which the answer left, `held` the time from the question's arrival to then.
struct RoundTrip {
  std::int64_t sent = 0;
  std::int64_t received = 0;
  std::int64_t peer = 0;
  std::int64_t held = 0;
};

/// Offset of a peer's CLOCK_MONOTONIC: its reading minus this machine's at the same moment, ns, and the maximum error.
/// The bound is half the travel time, independent of the shares of the two directions.
struct ClockOffset {
  std::int64_t ns = 0;
  std::int64_t error_ns = 0;
};

/// The clock of another machine, estimated from round trips: in each window of `kWindow` round trips the one with the
/// shortest travel time counts, because queues delay the others. The best offset is kept, but a newer one replaces an
/// old one, because clocks drift apart. The drift in windows after `keep()` is compared with it. One thread; it
/// allocates nothing.
class PeerClock {
 public:
  static constexpr int kWindow = 128;
  /// Relative drift of two unsynchronised clocks.
  static constexpr double kUnsteered = 1e-4;

  /// Adds one round trip; an impossible one (with a negative travel time) is ignored.
  void add(const RoundTrip& trip) noexcept;

  /// The best so far; nothing before the first window is full.
  std::optional<ClockOffset> offset() const noexcept { return first_; }
  /// Fixes the offset from now on: later deviations are drift.
  void keep() noexcept { kept_ = true; }

  /// Since `keep()`: the largest change of the offset that any window has shown, ns, and the largest that is certain,
  /// both errors taken off.
  std::int64_t worst_drift_ns() const noexcept { return worst_drift_; }
  std::int64_t certain_drift_ns() const noexcept { return certain_drift_; }
  /// Of all windows since `keep()`, the shortest travel time in the slowest one, ns.
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
