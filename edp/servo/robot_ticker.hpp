#pragma once

#include <cstdint>

#include "clock/wall/tick_statistics.hpp"
#include "edp/robot_clock.hpp"
#include "edp/servo/robot_grid.hpp"
#include "mrroc/types.hpp"

namespace mrroc::edp {

/// The ticks of a servo whose robot keeps the time: one for each package of its controller. When no package has come
/// for kSilent of the controller's periods, the wall clock ticks in its place, once in each period, so that the servo
/// finds the robot silent and its plan continues. A package for a time that has been ticked is not ticked again.
///
/// The servo's thread calls `wait_next`, which neither allocates nor locks; any thread may read the statistics.
class RobotTicker {
 public:
  /// `clock` must outlive it; `epoch` as `clock::Clock::epoch_ns()`, `period` of the servo in s.
  RobotTicker(RobotClock& clock, std::int64_t epoch, double period) noexcept;

  /// A place on the common grid: so much of its period after a tick has begun.
  struct Place {
    Tick tick = 0;
    double ahead = 0;     ///< 0 <= ahead < 1
    double measured = 0;  ///< when the period of the last package began, ticks: before this one if none has come
  };
  /// Waits for the next tick: at least kLeast of a period after the last one.
  Place wait_next() noexcept;

  /// The lateness of a tick is that of its set-point beside robots on the grid: the skew.
  const clock::TickStatistics& statistics() const noexcept { return statistics_; }

  static constexpr double kSilent = 2.5;
  static constexpr double kLeast = 0.5;

 private:
  double on_wall(std::int64_t ns) const noexcept { return static_cast<double>(ns - epoch_) / period_; }

  RobotClock& clock_;
  const std::int64_t epoch_;
  const double period_;  ///< of the servo, ns
  const double beat_;    ///< of the controller, ns
  RobotGrid grid_;
  double last_ = -kLeast;
  double measured_ = 0;
  bool ticked_ = false;
  clock::TickStatistics statistics_;
};

}  // namespace mrroc::edp
