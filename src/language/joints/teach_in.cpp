#include "mrroc/generators/teach_in.hpp"

#include "core/require.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

constexpr double kInexact = 1e-3;  // of a period: sums of periods are not exact

}  // namespace

TeachIn::TeachIn(Robot& robot, TaughtPath& path, double interval, std::size_t most)
    : Generator("TeachIn"), robot_(&robot), path_(&path), interval_(interval), most_(most) {
  require_above_zero("TeachIn", "interval", interval);
}

TeachIn::TeachIn(Robot& robot, TaughtPath& path) : Generator("TeachIn"), robot_(&robot), path_(&path), most_(kMost) {}

void TeachIn::start() {
  if (interval_) path_->points.clear();
  path_->timed = interval_.has_value();
  path_->points.reserve(most_);
  time_ = next_ = 0;
  resume();
  if (!interval_)
    while (robot_->task().take_trigger()) {  // from before the instruction
    }
}

void TeachIn::resume() { last_ = robot_->known_state().desired_tick; }

bool TeachIn::terminal_condition() {
  const Tick now = robot_->state().desired_tick;
  const double period = robot_->task().servo_period();
  time_ += static_cast<double>(now - last_) * period;
  last_ = now;
  if (!interval_) {
    if (robot_->task().take_trigger()) note(0);
  } else if (time_ >= next_ - kInexact * period) {
    note(time_);
    while (next_ <= time_ + kInexact * period) next_ += *interval_;
  }
  return false;
}

void TeachIn::note(double time) {
  if (path_->points.size() >= most_) {
    throw NonFatalError(ErrorCode::resources, "the taught path is full: " + std::to_string(most_) + " points",
                        {robot_->task().process_name(), robot_->name(), 0, robot_->state().tick});
  }
  path_->add(*robot_, time);
}

}  // namespace mrroc
