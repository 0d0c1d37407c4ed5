#include "edp/command/planner.hpp"

#include <algorithm>

#include "edp/force/force_law.hpp"
#include "edp/safety/error_report.hpp"

namespace mrroc::edp {
namespace {

constexpr std::uint32_t kMaxStretchedSteps = 4 * kMaxMotionSteps;
constexpr double kSameBranch = 1e-6;  // rad or m, between the end of a path and the joints of its goal

}  // namespace

Planner::Planner(const RobotModel& model, double period)
    : kinematics_(model), period_(period), stop_(model.parameters(), period), limits_(model, period) {}

void Planner::use(const ToolKinematics& kinematics) noexcept {
  kinematics_ = kinematics;
  stop_.use(kinematics.model().parameters());
  limits_.use(kinematics.model());
}

ErrorReport Planner::plan(const RobotCommand& command, const DesiredState& from, Pace pace,
                          Macrostep& macrostep) noexcept {
  const int steps = command.motion_steps;
  macrostep.stop = {.group = command.stop.group};
  if (steps < 1 || steps > kMaxMotionSteps)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_motion_steps, "N = %d, expected 1..%d", steps,
                       int{kMaxMotionSteps});
  if (command.reply_step < 1 || command.reply_step > steps + 1)
    return make_report(ErrorClass::non_fatal, ErrorCode::invalid_reply_step, "v = %d, expected 1..N+1 = %d",
                       int{command.reply_step}, steps + 1);
  if (command.kind == CommandKind::hold) {
    plan_stop(from, command.motion_steps, macrostep);
    // other robots of the same Move continue: they cannot wait for the end of a long stop, unless requested
    if (command.reply_step <= steps) cut_stop(command.motion_steps, macrostep);
  } else if (command.kind == CommandKind::force) {
    if (const ErrorReport report = check_force_law(command.force, command.twist); bad(report)) return report;
    macrostep.kind = Macrostep::Kind::force;
    macrostep.steps = command.motion_steps;
    macrostep.from = macrostep.to = from;
    macrostep.force = {command.force, command.twist, kinematics_.tool()};
  } else {
    if (const ErrorReport report = read_goal(command, from, kinematics_, steps * period_, period_, goal_); bad(report))
      return report;
    macrostep.kind = Macrostep::Kind::path;
    macrostep.steps = command.motion_steps;
    macrostep.from = from;
    ErrorReport report = plan_path(command.interpolation, macrostep);
    if (bad(report) && pace == Pace::stretched && !goal_.wants_velocity)
      report = stretch(command.interpolation, report, macrostep);
    if (bad(report)) return report;
    macrostep.stop = common_stop(command.stop, macrostep.to);
  }
  // v = N+1 means "after the macrostep", however long it has become
  macrostep.reply_step = command.reply_step > command.motion_steps ? macrostep.steps + 1 : command.reply_step;
  return {};
}

CommonStop Planner::common_stop(const CommonStop& wished, const DesiredState& from) noexcept {
  const CommonStop each_on_its_own{.group = wished.group};
  if (wished.ticks == 0 || from.at_rest()) return each_on_its_own;
  common_stop_.plan(from, wished, period_);
  return limits_.passes(common_stop_) ? wished : each_on_its_own;
}

void Planner::plan_stop(const DesiredState& from, std::uint32_t steps, Macrostep& macrostep) noexcept {
  stop_.plan(from);
  macrostep.kind = Macrostep::Kind::stop;
  macrostep.steps = std::max(steps, stop_.ticks());
  macrostep.from = from;
  macrostep.to = stop_.end();
}

void Planner::cut_stop(std::uint32_t steps, Macrostep& macrostep) const noexcept {
  if (macrostep.steps <= steps) return;
  macrostep.steps = steps;
  macrostep.to = stop_.at(steps * period_);
}

ErrorReport Planner::check(const Macrostep& macrostep) noexcept {
  const MacrostepPath& path = macrostep.path;
  const Quintic* quintic = path.space() == MacrostepPath::Space::joints ? &path.quintic() : nullptr;
  return limits_.check(
      macrostep.from, macrostep.to, macrostep.steps, quintic,
      [&path](double t, const JointVector& near, DesiredState& state) noexcept { return path.at(t, near, state); });
}

ErrorReport Planner::plan_path(Interpolation interpolation, Macrostep& macrostep) noexcept {
  const double duration = macrostep.steps * period_;
  const ErrorCode code =
      plan_to(goal_, interpolation, kinematics_, macrostep.from, duration, period_, macrostep.path, macrostep.to);
  if (code != ErrorCode::none && !goal_.wants_velocity)
    return make_report(ErrorClass::non_fatal, code, "no path to the goal: the tool turns by more than %.3g rad",
                       MacrostepPath::kTurnMax);
  return check(macrostep);
}

ErrorReport Planner::stretch(Interpolation interpolation, ErrorReport report, Macrostep& macrostep) noexcept {
  const std::uint32_t commanded = macrostep.steps;
  for (const bool at_rest : {false, true}) {
    if (at_rest) {
      goal_.joints = DesiredState::resting_at(goal_.joints.position);
      goal_.tool.twist.setZero();
      goal_.tool.rate.setZero();
    }
    macrostep.steps = commanded;
    while (bad(report = plan_path(interpolation, macrostep))) {
      // a longer duration corrects only the mean acceleration
      const ErrorReport end = limits_.check_end(macrostep.from, macrostep.to, macrostep.steps);
      if (bad(end) && end.code != ErrorCode::acceleration_limit) break;
      // a longer run-up swings farther out, a longer path to rest does not
      if (!at_rest && (report.code == ErrorCode::joint_limit || report.code == ErrorCode::motor_limit ||
                       report.code == ErrorCode::limit_switch))
        break;
      if (macrostep.steps >= kMaxStretchedSteps) break;
      macrostep.steps = std::min(macrostep.steps + macrostep.steps / 4 + 1, kMaxStretchedSteps);
    }
    if (!bad(report)) break;
  }
  return report;
}

}  // namespace mrroc::edp
