#pragma once

#include <vector>

#include "mrroc/robot.hpp"

namespace mrroc {

/// Computes when the robots of one Move or Wait begin their macrosteps together, and when they reply, so that the next
/// commands come in time. Both have a margin of ticks, doubled after each late command: on a slow machine the robots
/// would otherwise brake and start repeatedly. Task's thread; does not allocate.
class MacrostepTiming {
 public:
  /// Writes start ticks into the commands that have none; `now` is the present tick. While all rest: the tick at which
  /// the last of them can, and not before the margin, time for every command to arrive. While some move: the tick at
  /// which the last of these can; one that rests and cannot yet begins later on its own, a moving one would have to
  /// brake. Once a command has come late, a robot replies at least the margin before its macrostep's end (the first
  /// tick at the earliest) unless it is to reply after that.
  void plan(const std::vector<Robot*>& robots, Tick now);
  /// Whether the robot should have started from rest with the others but started after them.
  bool missed_by(const Robot& robot) const noexcept;
  /// Call after a late command.
  void allow_more_time() noexcept;

  /// The margin of a start from rest, ticks; of the usual macrostep's reply (N = 10, v = 8), too.
  static constexpr Tick kFirstMargin = 2;

 private:
  void align_starts(const std::vector<Robot*>& robots, Tick now);

  Tick start_ = 0;  ///< of the last commands, 0 when they did not start from rest
  Tick margin_ = kFirstMargin;
};

}  // namespace mrroc
