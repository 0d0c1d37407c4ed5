#include "edp/servo/synchroniser.hpp"

#include <cmath>
#include <numbers>

namespace mrroc::edp {

Synchroniser::Synchroniser(const RobotParameters& robot, const RobotParameters& shafts, double period) noexcept
    : count_(robot.axes.size()), period_(period) {
  for (std::size_t i = 0; i < count_; ++i) {
    const AxisParameters& axis = robot.axes[i];
    axes_[i] = {axis.synchro_coarse, axis.synchro_fine, axis.motor_synchro, shafts.axes[i].acceleration_max,
                shafts.axes[i].jerk_max};
    order_[i] = robot.synchro_order.empty() ? i : static_cast<std::size_t>(robot.synchro_order[i]);
  }
}

int Synchroniser::axis() const noexcept { return static_cast<int>(order_[place_]); }

void Synchroniser::start(const JointVector& shafts) noexcept {
  desired_ = DesiredState::resting_at(shafts);
  shift_ = JointVector::Zero(shafts.size());
  place_ = 0;
  phase_ = Phase::begin;
  turned_back_ = false;
}

void Synchroniser::change_speed(double velocity) noexcept {
  const Eigen::Index k = axis();
  const Axis& axis = axes_[order_[place_]];
  ramp_.plan(desired_.position[k], desired_.velocity[k] - velocity, desired_.acceleration[k], axis.acceleration,
             axis.jerk);
  speed_ = velocity;
  time_ = 0;
}

void Synchroniser::enter(Phase phase, double velocity) noexcept {
  phase_ = phase;
  change_speed(velocity);
}

Synchroniser::Status Synchroniser::next_axis() noexcept {
  shift_[axis()] = axes_[order_[place_]].synchro - found_;
  phase_ = Phase::begin;
  turned_back_ = false;
  if (place_ + 1 == count_) return Status::done;
  ++place_;
  return Status::running;
}

Synchroniser::Status Synchroniser::step(const HardwareInput& input, DesiredState& desired) noexcept {
  const auto i = order_[place_];
  const auto k = static_cast<Eigen::Index>(i);
  const AxisSwitches& switches = input.switches[i];
  const Axis& axis = axes_[i];
  const bool ahead = axis.coarse > 0 ? switches.upper_limit : switches.lower_limit;  // in the coarse direction
  const bool behind = axis.coarse > 0 ? switches.lower_limit : switches.upper_limit;
  switch (phase_) {
    case Phase::begin:
      enter(switches.synchro ? Phase::leave : Phase::coarse, switches.synchro ? -axis.coarse : axis.coarse);
      break;
    case Phase::leave:
      if (behind) return Status::failed;
      if (!switches.synchro) enter(Phase::coarse, axis.coarse);
      break;
    case Phase::coarse:
      if (switches.synchro) {
        enter(Phase::stop, 0);
      } else if (ahead) {
        if (turned_back_) return Status::failed;
        turned_back_ = true;
        enter(Phase::back, -axis.coarse);
      }
      break;
    case Phase::back:
      if (behind) return Status::failed;
      if (switches.synchro) phase_ = Phase::leave;
      break;
    case Phase::stop:
      if (time_ >= ramp_.duration()) enter(switches.synchro ? Phase::fine : Phase::slid, axis.fine);
      break;
    case Phase::slid:
      if (behind) return Status::failed;
      if (switches.synchro) phase_ = Phase::fine;
      break;
    case Phase::fine:
      if (behind) return Status::failed;
      if (switches.synchro) break;
      fine_start_ = input.motors[k];
      phase_ = Phase::pulse;
      [[fallthrough]];
    case Phase::pulse:
      if (switches.zero_pulse) {
        found_ = switches.zero_position;
        enter(Phase::rest, 0);
      } else if (std::abs(input.motors[k] - fine_start_) > kTurnsWithoutPulse * 2 * std::numbers::pi) {
        return Status::failed;
      }
      break;
    case Phase::rest:
      if (time_ < ramp_.duration()) break;
      if (next_axis() == Status::done) {
        desired = desired_;
        return Status::done;
      }
      desired = desired_;
      return Status::running;
  }
  time_ += period_;
  ramp_.at(time_, desired_.position[k], desired_.velocity[k], desired_.acceleration[k]);
  desired_.position[k] += speed_ * time_;
  desired_.velocity[k] += speed_;
  desired = desired_;
  return Status::running;
}

}  // namespace mrroc::edp
