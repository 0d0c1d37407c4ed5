#pragma once

#include <cstdint>
#include <string>

#include "clock/host.hpp"

namespace mrroc::cli {

/// Looks whether simulated time stands still because somebody computes or a message does not arrive. That is no error:
/// a planner may take a minute for a step. But who waits for it is told. Main thread.
class StallWatch {
 public:
  explicit StallWatch(const clock::ClockHost& clock) : clock_(clock) {}

  /// One line after 2 s of wall time without an event, after 4, 8, ..., who is waited for; otherwise empty. `now`: s of
  /// wall time. Under the real clock, and while everybody sleeps: always empty.
  std::string look(double now);

 private:
  static constexpr double kPatience = 2;  ///< s

  const clock::ClockHost& clock_;
  std::uint64_t delta_ = 0;
  Tick tick_ = 0;
  double since_ = 0;
  double patience_ = kPatience;
};

}  // namespace mrroc::cli
