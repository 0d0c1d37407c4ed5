#include "language/macrostep_timing.hpp"

#include <algorithm>

namespace mrroc {

namespace {

/// A robot that is late even then starts after the others.
constexpr Tick kLongestMargin = 256;

}  // namespace

void MacrostepTiming::plan(const std::vector<Robot*>& robots, Tick now) {
  align_starts(robots, now);
  if (margin_ == kFirstMargin) return;
  for (Robot* robot : robots) {
    RobotCommand& command = robot->command();
    if (command.reply_step > command.motion_steps) continue;
    const Tick latest = command.motion_steps > margin_ ? command.motion_steps - margin_ : 1;
    command.reply_step = static_cast<std::uint16_t>(std::min(Tick{command.reply_step}, latest));
  }
}

void MacrostepTiming::align_starts(const std::vector<Robot*>& robots, Tick now) {
  if (robots.size() < 2) return;
  const bool resting = std::all_of(robots.begin(), robots.end(), [](Robot* robot) { return robot->state().at_rest(); });
  Tick start = resting ? now + margin_ : 0;
  for (const Robot* robot : robots) {
    if (resting || !robot->state().at_rest()) start = std::max(start, robot->state().desired_tick);
  }
  start_ = resting ? start : 0;
  for (Robot* robot : robots) {
    if (robot->command().start_tick == 0) robot->command().start_tick = start;
  }
}

bool MacrostepTiming::missed_by(const Robot& robot) const noexcept {
  return start_ != 0 && margin_ < kLongestMargin && robot.command().start_tick == start_ &&
         robot.state().macrostep_start > start_;
}

void MacrostepTiming::allow_more_time() noexcept { margin_ = std::min(2 * margin_, kLongestMargin); }

}  // namespace mrroc
