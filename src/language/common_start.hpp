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
  /// Writes the start tick, the same for all, into the commands that have none; `now` is the present tick. Robots that
  /// all rest get a margin, time for every command to arrive; one that moves would have to brake for it.
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
