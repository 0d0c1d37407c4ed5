#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "clock/host.hpp"

namespace mrroc::cli {

/// Detects a process that computes without end, is blocked, or waits for a message that does not arrive: meanwhile all
/// others stand still in simulated time; under the real clock its robots do. This is not an error: a planner may take a
/// minute for a step. But the process is reported. Main thread.
class StallWatch {
 public:
  explicit StallWatch(const clock::ClockHost& clock) : clock_(clock) {}

  /// After 2 s of wall time, after 4, 8, ...: one line that names the process that all wait for, or the one that has
  /// not waited since; otherwise empty. `now`: s of wall time. While all processes sleep: always empty.
  std::string check(double now);

 private:
  static constexpr double kPatience = 2;  ///< s

  struct Stall {
    std::uint64_t mark = 0;  ///< changes whenever something happens
    double since = 0;
    double patience = kPatience;

    /// s without any event, when it is time to report them; else 0.
    double check(std::uint64_t present, double now);
  };

  std::string check_simulated_time(double now);
  std::string check_processes(double now);

  const clock::ClockHost& clock_;
  Stall time_;
  std::map<std::string, Stall> processes_;
};

}  // namespace mrroc::cli
