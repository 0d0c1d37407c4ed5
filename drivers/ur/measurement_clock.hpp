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
/// tick had. o increases by kDrift of the time, in case the controller's clock is the slower one. A reading that comes
/// late may contain a measurement after its tick, by up to kLatest. More than that shows that the servo's ticks are
/// longer than T; then g follows by kStep of the ticks, so that speeds are wrong by no more than that.
class MeasurementClock {
 public:
  struct Measured {
    Tick tick = 0;    ///< floor(x), at most the present one
    double rest = 0;  ///< x - tick: the measurement is so many servo periods after the tick
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
  static constexpr double kStep = 0.1;
  static constexpr double kMostAhead = 10;  ///< servo periods beyond kLatest, from which g follows at once

 private:
  double period_;
  double timestamp_ = 0;
  double offset_ = 0;   ///< o, s
  double grid_ = 0;     ///< g, s
  double present_ = 0;  ///< tick of the last package's reading
  Tick last_ = 0;
  bool started_ = false;
};

}  // namespace mrroc::ur
