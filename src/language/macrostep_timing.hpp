#pragma once

#include <vector>

#include "mrroc/robot.hpp"

namespace mrroc {

/// The robot's desired state is at rest.
bool rests(const RobotState& state) noexcept;

/// When the robots of one Move or Wait begin their macrosteps, together, and when they reply, so that the next commands
/// come in time: a margin of ticks, twice as many after each command that came late. A slow machine would else make the
/// robots brake and start over and over. Task's thread; allocates nothing.
class MacrostepTiming {
 public:
  /// Writes the start tick, the same for all, into the commands that have none; `now` is the present tick. Robots that
  /// all rest get the margin for the commands to arrive; one that moves would have to brake for it. Once a command has
  /// come late, a robot replies at least the margin before its macrostep's end (the first tick at the earliest) unless
  /// it is to reply after that.
  void plan(const std::vector<Robot*>& robots, Tick now);
  /// The robot was to start from rest with the others and started after them.
  bool missed_by(const Robot& robot) const noexcept;
  /// A command came late.
  void allow_more_time() noexcept;

 private:
  void align_starts(const std::vector<Robot*>& robots, Tick now);

  static constexpr Tick kFirstMargin = 2;  // of the usual macrostep, 10 / 8, too
  Tick start_ = 0;                         ///< of the last commands, 0 when they did not start from rest
  Tick margin_ = kFirstMargin;
};

}  // namespace mrroc
