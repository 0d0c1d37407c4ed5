#pragma once

#include <vector>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The robot's desired state is at rest.
bool rests(const RobotState& state) noexcept;

/// Start ticks of the common macrosteps of one Move or Wait, and reply ticks early enough for the next commands. Both
/// have a margin of ticks that doubles after each late command: otherwise the robots would brake and start repeatedly
/// on a slow machine. Task's thread; allocates nothing.
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

 private:
  void align_starts(const std::vector<Robot*>& robots, Tick now);

  static constexpr Tick kFirstMargin = 2;  // of the usual macrostep, 10 / 8, too
  Tick start_ = 0;                         ///< of the last commands, 0 when they did not start from rest
  Tick margin_ = kFirstMargin;
};

}  // namespace mrroc
