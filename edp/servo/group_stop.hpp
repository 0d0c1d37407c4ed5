#pragma once

#include "clock/group_stops.hpp"
#include "language/limit_check.hpp"
#include "language/stops/common_stop_path.hpp"

namespace mrroc::edp {

/// What one robot and the others of its motion do for each other's stops (CommonStop::group): it announces its own,
/// and finds that another one has stopped. Motions are named by their group; 0: in no group. The servo's thread;
/// allocates only in its constructor, never throws.
class GroupStop {
 public:
  GroupStop(const RobotModel& model, double period) : limits_(model, period), period_(period) {}
  /// Robot `robot` of the deployment; `stops` must outlive this object. Without it the robot is alone.
  void use(clock::GroupStops& stops, std::size_t robot) noexcept {
    stops_ = &stops;
    robot_ = robot;
  }
  /// From now on joints are those of `model`.
  void use(const RobotModel& model) noexcept { limits_.use(model); }

  /// Whether its stops reach others at all.
  bool is_shared() const noexcept { return stops_ != nullptr && robot_ < clock::GroupStops::kMaxRobots; }
  /// The robot stops in `tick`, or begins to with the others in the next one.
  void announce(std::uint64_t group, Tick tick) noexcept {
    if (group == 0) return;
    given_up_ = group;
    if (stops_ != nullptr) stops_->announce(robot_, group, tick);
  }
  /// Whether one of `group`, or this robot, has stopped before `tick`; then the motion is given up.
  bool is_due(std::uint64_t group, Tick tick) noexcept {
    if (group == 0 || stops_ == nullptr || !stops_->has_stopped(group, tick)) return false;
    given_up_ = group;
    return true;
  }
  /// The last motion that has been given up: its commands hold the robot.
  std::uint64_t given_up() const noexcept { return given_up_; }

  /// Whether `stop` from `from`, in the middle of a macrostep, stays inside the limits. Its planner has checked it from
  /// the macrostep's end only. False for one of more than 500 ticks, which is too long for a fault, and for a check
  /// in one tick.
  bool passes(const DesiredState& from, const CommonStop& stop, const LimitSwitches& switches) noexcept {
    constexpr std::uint32_t kMostTicks = 500;
    if (stop.ticks > kMostTicks) return false;
    path_.plan(from, stop, period_);
    limits_.stand_on(switches);
    limits_.begin(from);
    return limits_.passes(path_);
  }

 private:
  clock::GroupStops* stops_ = nullptr;
  std::size_t robot_ = 0;
  std::uint64_t given_up_ = 0;
  LimitCheck limits_;
  CommonStopPath path_;
  double period_;
};

}  // namespace mrroc::edp
