#include "mrroc/generators/hold.hpp"

#include <cmath>

#include "core/require.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

Hold::Hold(Robot& robot, double duration) : Generator("Hold"), robot_(&robot), duration_(duration) {
  require_not_negative("Hold", "duration", duration);
}

void Hold::start() {
  held_ = 0;
  resume();
}

void Hold::resume() { last_tick_ = robot_->state().tick; }

bool Hold::terminal_condition() {
  const Tick tick = robot_->state().tick;
  held_ += static_cast<double>(tick - last_tick_) * robot_->task().servo_period();
  last_tick_ = tick;
  // half a tick of tolerance: sums of periods are not exact
  return held_ >= duration_ - 0.5 * robot_->task().servo_period();
}

}  // namespace mrroc
