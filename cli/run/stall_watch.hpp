#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "clock/host.hpp"

namespace mrroc::cli {

/// Looks whether someone computes without end, is blocked, or waits for a message that does not arrive: in simulated
/// time all others stand still meanwhile, under the real clock its robots do. That is no error: a planner may take a
/// minute for a step. But who it is is told. Main thread.
class StallWatch {
 public:
  explicit StallWatch(const clock::ClockHost& clock) : clock_(clock) {}

  /// After 2 s of wall time, after 4, 8, ...: one line that says who is waited for, or which process has not waited for
  /// anything since; otherwise empty. `now`: s of wall time. While everybody sleeps: always empty.
  std::string look(double now);

 private:
  static constexpr double kPatience = 2;  ///< s

  struct Stall {
    std::uint64_t mark = 0;  ///< changes whenever something happens
    double since = 0;
    double patience = kPatience;

    /// How long nothing has happened, when it is time to say so; else 0.
    double look(std::uint64_t present, double now);
  };

  std::string look_at_simulated_time(double now);
  std::string look_at_processes(double now);

  const clock::ClockHost& clock_;
  Stall time_;
  std::map<std::string, Stall> processes_;
};

}  // namespace mrroc::cli
