#include "language/common_start.hpp"

#include <algorithm>

namespace mrroc {

namespace {

/// A robot that is late even then starts after the others.
constexpr Tick kLongestMargin = 256;

}  // namespace

bool rests(const RobotState& state) noexcept {
  return (state.desired_velocity.array() == 0.0).all() && (state.desired_acceleration.array() == 0.0).all();
}

void CommonStart::align(const std::vector<Robot*>& robots, Tick now) {
  if (robots.size() < 2) return;
  const bool resting = std::all_of(robots.begin(), robots.end(), [](Robot* robot) { return rests(robot->state()); });
  Tick start = resting ? now + margin_ : 0;
  for (const Robot* robot : robots) {
    if (resting || !rests(robot->state())) start = std::max(start, robot->state().desired_tick);
  }
  start_ = resting ? start : 0;
  for (Robot* robot : robots) {
    if (robot->command().start_tick == 0) robot->command().start_tick = start;
  }
}

bool CommonStart::missed_by(const Robot& robot) const noexcept {
  return start_ != 0 && margin_ < kLongestMargin && robot.command().start_tick == start_ &&
         robot.state().macrostep_start > start_;
}

void CommonStart::allow_more_time() noexcept { margin_ = std::min(2 * margin_, kLongestMargin); }

}  // namespace mrroc
