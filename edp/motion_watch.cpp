#include "edp/motion_watch.hpp"

#include <cmath>

namespace mrroc::edp {

Fault MotionWatch::look(const std::vector<AxisParameters>& axes, const JointVector& joints, const JointVector& motors,
                        const JointVector& desired_motors, Tick read_tick, bool moves) noexcept {
  if (readings_ == 0) {
    ring_[0] = {read_tick, joints};
    readings_ = 1;
    motors_ = motors;
    desired_there_ = desired_motors;
    return {};
  }
  const Fault fast = look_at_speed(axes, joints, read_tick);
  const Fault stuck = look_at_shafts(axes, motors, desired_motors);
  if (fast.code != ErrorCode::none || !moves) return fast;
  return stuck;
}

Fault MotionWatch::look_at_speed(const std::vector<AxisParameters>& axes, const JointVector& joints,
                                 Tick read_tick) noexcept {
  if (read_tick <= ring_[(readings_ - 1) % kReadings].tick) return {};  // the same reading again
  const Reading oldest = ring_[readings_ % kReadings];
  ring_[readings_ % kReadings] = {read_tick, joints};
  if (readings_++ < kReadings) return {};
  const double time = period_ * static_cast<double>(read_tick - oldest.tick);
  Fault fault;
  for (Eigen::Index i = joints.size(); i-- > 0;) {
    const double speed = std::abs(joints[i] - oldest.joints[i]) / time;
    const double limit = kOverspeed * axes[static_cast<std::size_t>(i)].velocity_max;
    if (!(speed <= limit)) fault = {ErrorCode::overspeed, static_cast<int>(i), speed, limit};
  }
  return fault;
}

Fault MotionWatch::look_at_shafts(const std::vector<AxisParameters>& axes, const JointVector& motors,
                                  const JointVector& desired_motors) noexcept {
  Fault fault;
  for (Eigen::Index i = motors.size(); i-- > 0;) {
    if (motors[i] != motors_[i]) {
      motors_[i] = motors[i];
      desired_there_[i] = desired_motors[i];
      continue;
    }
    const double way = std::abs(desired_motors[i] - desired_there_[i]);
    const double limit = axes[static_cast<std::size_t>(i)].stuck_max;
    if (!(way <= limit)) fault = {ErrorCode::axis_stuck, static_cast<int>(i), way, limit};
  }
  return fault;
}

}  // namespace mrroc::edp
