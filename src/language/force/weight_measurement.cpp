#include "mrroc/generators/weight_measurement.hpp"

#include <utility>

#include "core/require.hpp"
#include "language/joints/joint_leg.hpp"
#include "language/joints/joint_targets.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

WeightMeasurement::WeightMeasurement(Robot& robot, std::vector<JointVector> postures, const Weighing& weighing)
    : Generator("WeightMeasurement"),
      robot_(&robot),
      postures_(std::move(postures)),
      weighing_(weighing),
      readings_(weighing.offset, weighing.gravity),
      leg_(std::make_unique<JointLeg>(robot)) {
  require(!postures_.empty(), "WeightMeasurement", "postures", 0, "at least three");
  for (const JointVector& posture : postures_) check_joints(robot, posture, "a posture of WeightMeasurement");
  require(weighing.speed > 0 && weighing.speed <= 1, "WeightMeasurement", "speed", weighing.speed,
          "above 0 and at most 1");
  require_not_negative("WeightMeasurement", "settling time", weighing.settling);
  require_not_negative("WeightMeasurement", "measuring time", weighing.measuring);
  readings_.reserve(postures_.size());
}

WeightMeasurement::~WeightMeasurement() = default;
WeightMeasurement::WeightMeasurement(WeightMeasurement&&) noexcept = default;
WeightMeasurement& WeightMeasurement::operator=(WeightMeasurement&&) noexcept = default;

void WeightMeasurement::start() {
  readings_.clear();
  posture_ = 0;
  resume();
}

void WeightMeasurement::resume() {
  const RobotState& state = robot_->known_state();
  if (posture_ < postures_.size()) leg_->plan(postures_[posture_], weighing_.speed);
  time_ = 0;
  resting_ = false;
  rest_ = 0;
  last_ = state.tick;
  sum_.setZero();
  count_ = 0;
}

bool WeightMeasurement::terminal_condition() {
  if (posture_ >= postures_.size()) return true;
  read();
  return posture_ >= postures_.size();
}

void WeightMeasurement::read() {
  const RobotState& state = robot_->state();
  const double period = robot_->task().servo_period();
  const Tick before = std::exchange(last_, state.tick);
  if (!std::exchange(resting_, leg_->over(time_))) return;  // the previous step still moved there
  rest_ += static_cast<double>(last_ - before) * period;
  if (rest_ < weighing_.settling) return;
  sum_ += state.wrench;
  ++count_;
  if (rest_ < weighing_.settling + weighing_.measuring - 0.5 * period) return;
  readings_.add(state.pose.linear(), sum_ / count_);
  if (++posture_ < postures_.size()) resume();
}

void WeightMeasurement::next_state() {
  if (leg_->over(time_)) return;  // rests
  time_ += robot_->step_duration();
  leg_->write(time_, robot_->command());
}

}  // namespace mrroc
