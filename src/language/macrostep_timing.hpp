#pragma once

#include <vector>

#include "mrroc/robot.hpp"

namespace mrroc {

/// When the robots of one Move or Wait begin their macrosteps, together, and when they reply, so that the next commands
/// come in time. Both with a margin of ticks, twice as many after each command that came late: a slow machine would
/// else make the robots brake and start over and over. Task's thread; allocates nothing.
class MacrostepTiming {
 public:
  /// Writes start ticks into the commands that have none; `now` is the present tick. While all rest: the tick at which
  /// the last of them can, and not before the margin, time for every command to arrive. While some move: the tick at
  /// which the last of these can; one that rests and cannot yet begins later on its own, a moving one would have to
  /// brake. Once a command has come late, a robot replies at least the margin before its macrostep's end (the first
  /// tick at the earliest) unless it is to reply after that.
  void plan(const std::vector<Robot*>& robots, Tick now);
  /// The robot was to start from rest with the others and started after them.
  bool missed_by(const Robot& robot) const noexcept;
  /// A command came late.
  void allow_more_time() noexcept;

  /// The margin of a start from rest, ticks; of the usual macrostep's reply (N = 10, v = 8), too.
  static constexpr Tick kFirstMargin = 2;

 private:
  void align_starts(const std::vector<Robot*>& robots, Tick now);

  Tick start_ = 0;  ///< of the last commands, 0 when they did not start from rest
  Tick margin_ = kFirstMargin;
};

}  // namespace mrroc
