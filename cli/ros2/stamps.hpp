#pragma once

#include <cstdint>
#include <optional>

#include "messages/builtin_interfaces/time.hpp"
#include "mrroc/types.hpp"

namespace mrroc::cli {

/// The times that ROS 2 sees for ticks. Of a simulated clock: tick * period, as /clock says. Of the real clock: the
/// system's time at that tick, since ROS 2 compares it with its own. One thread.
class Stamps {
 public:
  /// `period` in s.
  Stamps(bool simulated, double period) : simulated_(simulated), period_(period) {}

  bool simulated() const noexcept { return simulated_; }
  /// Of a tick whose state arrived at `now` (ns of the system's clock). A state can only arrive late, so the least
  /// difference of `now` and the tick's own time is that of the two clocks; it may rise by 200 ppm, because the
  /// clocks drift and the system's is adjusted.
  messages::builtin_interfaces::Time of(Tick tick, std::int64_t now);
  /// Of what has no tick.
  messages::builtin_interfaces::Time at(std::int64_t now) const;

 private:
  bool simulated_;
  double period_;
  Tick newest_ = 0;
  std::optional<std::int64_t> offset_;  // ns
  std::int64_t seen_ = 0;               // when it was compared last, ns
};

}  // namespace mrroc::cli
