#pragma once

#include <cstdint>

#include "edp/robot_clock.hpp"

namespace mrroc::edp {

/// Places the periods of a robot's controller on the common grid, whose tick k begins at epoch + k T. With t the time
/// of a package at the controller and r that of its reception, a period begins at
///
///   x* = (t + o - epoch) / T   (ticks, not an integer),   o the least r - t so far,
///
/// which is when the quickest package came. o increases by kDrift of the time, because the two clocks differ. From
/// package to package x advances by the controller's own time, and by at most kSlew of it towards x*: the jitter of the
/// network does not enter a motion. A distance above kFarthest, as after a first package that was late, is corrected at
/// once. A time that goes back, or forward by more than kRestart, is another clock: its controller has restarted.
///
/// Robots of one Move thereby share the grid at all times, each with a period and a phase of its own.
class RobotGrid {
 public:
  /// `epoch` of CLOCK_MONOTONIC, ns; `period` T, s.
  RobotGrid(std::int64_t epoch, double period) noexcept : epoch_(epoch), period_(period) {}

  /// x of this package, ticks. Servo thread.
  double place(const Beat& beat) noexcept;

  static constexpr double kDrift = 3e-4;
  static constexpr double kSlew = 2e-3;
  static constexpr double kFarthest = 1;  ///< ticks
  static constexpr double kRestart = 60;  ///< s

 private:
  std::int64_t epoch_;
  double period_;
  double time_ = 0;    ///< t of the last package
  double offset_ = 0;  ///< o - epoch, s
  double place_ = 0;   ///< x of the last package
  bool started_ = false;
};

}  // namespace mrroc::edp
