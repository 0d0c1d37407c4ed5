#pragma once

#include <cstdint>

#include "mrroc/types.hpp"

namespace mrroc::ur {

/// Converts the controller's time of a package into ticks of the servo.
///
/// Both count their periods with clocks of their own, and a package waits for the network and for the servo's tick: one
/// tick finds no new package, the next one two. Differences of positions divided by ticks would be speeds of half and
/// twice the robot's. So a package was measured at
///
///   x = (t + o - g) / T,
///
/// with t the controller's time, T the servo's period, o the least difference of the times of reception and t, and g
/// the least difference of the time of a reading and its tick's k T: what the quickest package and the most punctual
/// tick had. o increases by kDrift of the time, in case the controller's clock is the slower one.
class MeasurementClock {
 public:
  struct Measured {
    Tick tick = 0;    ///< floor(x), at most the present one
    double rest = 0;  ///< x - tick, servo periods by which the measurement is later than the tick
    double late = 0;  ///< servo periods by which x had to be held back now: the time since the package before is longer
  };

  /// `period` of the servo in s.
  explicit MeasurementClock(double period) noexcept : period_(period) {}

  /// A package with the controller's time `timestamp` (s), received at `received` and read in tick `now` at `read`
  /// (CLOCK_MONOTONIC, ns). Ticks do not go back. A time that goes back, or forward by more than kRestart, is another
  /// clock.
  Measured take(double timestamp, std::int64_t received, Tick now, std::int64_t read) noexcept;

  static constexpr double kDrift = 2e-4;
  static constexpr double kRestart = 60;  ///< s
  static constexpr double kLatest = 1;    ///< servo periods

 private:
  double period_;
  double timestamp_ = 0;
  double offset_ = 0;  ///< o, s
  double grid_ = 0;    ///< g, s
  Tick last_ = 0;
  bool started_ = false;
};

}  // namespace mrroc::ur
