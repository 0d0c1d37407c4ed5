#pragma once

#include <vector>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The robot's desired state is at rest.
bool rests(const RobotState& state) noexcept;

/// Chooses the tick at which the robots of one Move or Wait begin their macrosteps together. Task's thread; allocates
/// nothing.
class CommonStart {
 public:
  /// Writes start ticks into the commands that have none; `now` is the present tick. While all rest: the tick at which
  /// the last of them can, and not before a margin, time for every command to arrive. While some move: the tick at
  /// which the last of these can; one that rests and cannot yet begins later by itself, a moving one would have to
  /// brake.
  void align(const std::vector<Robot*>& robots, Tick now);
  /// The robot was to start from rest with the others and started after them.
  bool missed_by(const Robot& robot) const noexcept;
  /// A command came late: the margin is doubled, so that a slow machine does not make the robots start over and over.
  void allow_more_time() noexcept;

 private:
  Tick start_ = 0;   ///< of the last commands, 0 when they did not start from rest
  Tick margin_ = 2;  ///< ticks
};

}  // namespace mrroc
