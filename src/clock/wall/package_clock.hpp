#pragma once

#include <cstdint>

namespace mrroc::clock {

/// Judges each package of a controller by its time there and the time at which it was received, for BeatCounters.
///
/// With T the period, a package whose controller time is n T after that of the package before has n - 1 lost ones
/// before it, and n = 0 is a doubled one. It is late when it is received more than T after the time that the earliest
/// packages promise. That promise moves by kDrift, because the two clocks differ. A controller time that goes back, or
/// forward by more than kRestart, is another clock: the controller has restarted.
class PackageClock {
 public:
  struct Verdict {
    bool doubled = false;
    bool late = false;
    bool restarted = false;
    std::uint64_t lost = 0;
  };

  /// `period` in s.
  void start(double period) noexcept;
  /// `timestamp`: of the controller, s; `received`: CLOCK_MONOTONIC, ns.
  Verdict take(double timestamp, std::int64_t received) noexcept;

 private:
  static constexpr double kDrift = 2e-4;
  static constexpr double kRestart = 60;  // s

  double period_ = 0;
  double last_ = 0;
  double offset_ = 0;  ///< s, least of received - timestamp
  bool started_ = false;
};

}  // namespace mrroc::clock
