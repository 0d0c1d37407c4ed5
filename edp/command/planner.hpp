#pragma once

#include "edp/command/macrostep.hpp"
#include "language/limit_check.hpp"
#include "language/macrostep/macrostep_goal.hpp"
#include "language/stops/common_stop_path.hpp"
#include "language/stops/stop.hpp"
#include "mrroc/robot_command.hpp"
#include "mrroc/robot_state.hpp"
#include "mrroc/tool_kinematics.hpp"

namespace mrroc::edp {

/// The treatment of a macrostep that is too fast.
enum class Pace {
  as_commanded,  ///< refuse it
  stretched      ///< let it take longer: the command was planned from an outdated state
};

/// Turns a command into a macrostep, or reports why it cannot: all is validated here, before acceptance. Increments
/// (`relative`) are on the desired state `from`, for joints, motors and poses alike, so that they never add up an
/// error.
///
/// Pace::stretched lets the duration grow, by a quarter at a time and to at most 4 kMaxMotionSteps, until the limits
/// hold; when the run-up to an end velocity does not fit, the macrostep ends at rest instead.
///
/// Allocates only in its constructor, never throws; the comms thread.
class Planner {
 public:
  /// Throws SystemError when an axis has no acceleration or jerk limit.
  Planner(const RobotModel& model, double period);
  /// Switches to this model and tool of the same robot; the model must outlive this object.
  void use(const ToolKinematics& kinematics) noexcept;
  const ToolKinematics& kinematics() const noexcept { return kinematics_; }
  /// The limit switches on which the axes are: they may only move away from there.
  void stand_on(const LimitSwitches& switches) noexcept { limits_.stand_on(switches); }

  /// Fills kind, steps, reply_step, from, to, path and stop of `macrostep`; the caller fills the rest. Class `none`, or
  /// a non-fatal error, which leaves `macrostep` undefined. Not for queries. Of a force motion only the values are
  /// checked: its end is unknown.
  ErrorReport plan(const RobotCommand& command, const DesiredState& from, Pace pace, Macrostep& macrostep) noexcept;

  /// Plans the stop from `from`, lasting at least `steps` ticks.
  void plan_stop(const DesiredState& from, std::uint32_t steps, Macrostep& macrostep) noexcept;

 private:
  /// Ends the stop just planned after `steps` ticks, even in motion.
  void cut_stop(std::uint32_t steps, Macrostep& macrostep) const noexcept;
  /// `wished`, where it leads from the end of the macrostep just checked within the limits.
  CommonStop common_stop(const CommonStop& wished, const DesiredState& from) noexcept;
  ErrorReport check(const Macrostep& macrostep) noexcept;
  ErrorReport plan_path(Interpolation interpolation, Macrostep& macrostep) noexcept;
  ErrorReport stretch(Interpolation interpolation, ErrorReport report, Macrostep& macrostep) noexcept;

  ToolKinematics kinematics_;
  double period_;
  Stop stop_;
  CommonStopPath common_stop_;
  LimitCheck limits_;
  MacrostepGoal goal_;  ///< of the command being planned
};

}  // namespace mrroc::edp
