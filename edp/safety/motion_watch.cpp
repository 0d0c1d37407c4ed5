#include "edp/safety/motion_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mrroc::edp {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double increment(const AxisParameters& axis) noexcept { return 2 * std::numbers::pi / axis.encoder_increments; }

/// rad/s of a free drive that had `speed` a period before, pushed by `current` all that time.
double next_speed(const AxisParameters& axis, double speed, double current, double period) noexcept {
  const double push = std::copysign(std::max(std::abs(current) - axis.stuck_current, 0.0), current);
  const double rate = period / axis.rotor_inertia;
  return (speed + rate * axis.torque_constant * push) / (1.0 + rate * axis.viscous_friction);
}

}  // namespace

Fault MotionWatch::check(const RobotModel& model, const Seen& seen, Taken taken, bool moves, int homing) noexcept {
  if (readings_ == 0) {
    begin(model, seen, taken);
    return {};
  }
  const Fault fast = check_speed(model.parameters().axes, seen.joints, taken, homing);
  const Fault stuck = check_shafts(model, seen, taken.unseen, homing);
  if (fast.code != ErrorCode::none || !moves) return fast;
  return stuck;
}

void MotionWatch::begin(const RobotModel& model, const Seen& seen, Taken taken) noexcept {
  ring_[0] = {taken, seen.joints};
  readings_ = 1;
  speed_ = seen.velocity;
  set_points_.begin(seen.desired_motors);
  motors_ = seen.motors;
  desired_there_ = desired_last_ = seen.desired_motors;
  current_there_ = seen.current;
  pushed_.setZero(seen.motors.size());
  JointVector increments(seen.motors.size());
  for (Eigen::Index i = 0; i < increments.size(); ++i)
    increments[i] = increment(model.parameters().axes[static_cast<std::size_t>(i)]);
  const JointMatrix ratio = model.transmission(seen.joints).inverse();
  tremble_ = kTremble * (ratio.cwiseAbs() * increments);
}

Fault MotionWatch::check_speed(const std::vector<AxisParameters>& axes, const JointVector& joints, Taken taken,
                               int homing) noexcept {
  if (taken.time <= ring_[(readings_ - 1) % kReadings].taken.time) return {};  // the same reading again
  const Reading last = ring_[(readings_ - 1) % kReadings], oldest = ring_[readings_ % kReadings];
  const bool full = readings_ >= kReadings;
  ring_[readings_++ % kReadings] = {taken, joints};
  const double periods = taken.time - last.taken.time;
  const double longest = period_ * (periods + taken.late);
  const double shortest = period_ * (periods - last.taken.late);
  const double whole_time = period_ * (taken.time - oldest.taken.time + taken.late);
  const bool exact = longest == shortest;
  Fault fault;
  for (Eigen::Index i = joints.size(); i-- > 0;) {
    const double latest = (joints[i] - last.joints[i]) / longest;
    const double change = latest - speed_[i];
    // when the times are uncertain, so is a change that would reverse the motion
    const double ahead = exact ? std::abs(latest + change) : std::abs(latest) + std::copysign(1, latest) * change;
    const double next = ahead - tremble_[i] / longest;
    const double over_all = full ? std::abs(joints[i] - oldest.joints[i]) / whole_time : 0.0;
    const double speed = i == homing ? over_all : std::max(over_all, next);
    const double limit = kOverspeed * axes[static_cast<std::size_t>(i)].velocity_max;
    if (!(speed <= limit)) fault = {ErrorCode::overspeed, static_cast<int>(i), Excess{speed, limit}};
    speed_[i] = shortest > 0 ? (joints[i] - last.joints[i]) / shortest : kUnknown;
  }
  return fault;
}

Fault MotionWatch::check_shafts(const RobotModel& model, const Seen& seen, std::uint64_t unseen, int homing) noexcept {
  set_points_.push(seen.desired_motors);
  const JointVector& desired = set_points_.before(unseen);
  Fault fault;
  for (Eigen::Index i = seen.motors.size(); i-- > 0;) {
    if (seen.motors[i] != motors_[i]) {
      motors_[i] = seen.motors[i];
      desired_there_[i] = desired[i];
      current_there_[i] = seen.current[i];
      pushed_[i] = 0;
      continue;
    }
    const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
    const double way = std::abs(desired[i] - desired_there_[i]);
    if (!(way <= axis.stuck_max)) fault = {ErrorCode::axis_stuck, static_cast<int>(i), Excess{way, axis.stuck_max}};
    // a drive that homes moves on its own, in every mode
    const bool asked = seen.given || (desired[i] != desired_last_[i] && way > kTremble * increment(axis));
    const bool on_its_own = i == homing || !asked;
    if (on_its_own) current_there_[i] = seen.current[i];
    pushed_[i] = on_its_own ? 0 : next_speed(axis, pushed_[i], seen.current[i] - current_there_[i], period_);
  }
  desired_last_ = desired;
  return fault.code != ErrorCode::none || pushed_.isZero(0) ? fault : check_push(model, seen.joints);
}

/// The push of each shaft alone, as the only motion that its encoder hides.
Fault MotionWatch::check_push(const RobotModel& model, const JointVector& joints) const noexcept {
  const std::vector<AxisParameters>& axes = model.parameters().axes;
  const Eigen::PartialPivLU<JointMatrix> ratio(model.transmission(joints));
  Fault fault;
  for (Eigen::Index i = pushed_.size(); i-- > 0;) {
    if (pushed_[i] == 0) continue;
    const JointVector speeds = ratio.solve(pushed_[i] * JointVector::Unit(pushed_.size(), i));
    for (Eigen::Index j = pushed_.size(); j-- > 0;) {
      const double speed = std::abs(speeds[j]);
      const double limit = kPushed * axes[static_cast<std::size_t>(j)].velocity_max;
      if (speed > limit) fault = {ErrorCode::axis_stuck, static_cast<int>(i), Excess{speed, limit}};
    }
  }
  return fault;
}

}  // namespace mrroc::edp
