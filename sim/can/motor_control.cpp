#include "sim/can/motor_control.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::sim {

namespace {

// homing is slow: the shafts of all our motors can follow this
constexpr double kHomingAcceleration = 100;  // rad/s^2
constexpr double kHomingJerk = 2500;         // rad/s^3

edp::Synchroniser one_axis_synchroniser(AxisParameters axis, double period) {
  axis.motor_synchro = 0;
  axis.acceleration_max = kHomingAcceleration;
  axis.jerk_max = kHomingJerk;
  RobotParameters one;
  one.axes.push_back(axis);
  return {one, one, period};
}

}  // namespace

MotorControl::MotorControl(const AxisParameters& axis, double period) : axis_(axis), period_(period), regulator_(axis) {
  input_.motors = input_.current = JointVector::Zero(1);
}

void MotorControl::measure(double position, const edp::AxisSwitches& switches) noexcept {
  before_ = measured_ ? position_ : position;
  position_ = position;
  measured_ = true;
  input_.motors[0] = position;
  input_.switches[0] = switches;
}

double MotorControl::off() noexcept {
  regulator_.reset();
  commanded_ = position_;
  commanded_velocity_ = 0;
  return 0;
}

double MotorControl::regulate(double position) noexcept {
  const double increment = position - commanded_;
  commanded_ = position;
  commanded_velocity_ = increment / period_;
  return regulator_.step(increment, position_ - before_);
}

double MotorControl::follow_position(double position) noexcept { return regulate(position); }

double MotorControl::follow_velocity(double velocity) noexcept { return regulate(commanded_ + velocity * period_); }

double MotorControl::follow_current(double current) noexcept {
  regulator_.reset();
  commanded_ = position_;
  commanded_velocity_ = velocity();
  return std::clamp(current, -axis_.current_max, axis_.current_max);
}

double MotorControl::slow_down(double deceleration) noexcept {
  const double step = deceleration * period_;
  const double slower = std::max(0.0, std::abs(commanded_velocity_) - step);
  const double velocity = std::copysign(slower, commanded_velocity_);
  const double current = regulate(commanded_ + velocity * period_);
  commanded_velocity_ = slower == 0 ? 0 : velocity;
  return current;
}

void MotorControl::start_homing(double direction, double speed_switch, double speed_zero) noexcept {
  AxisParameters axis = axis_;
  axis.synchro_coarse = direction * speed_switch;
  axis.synchro_fine = -direction * speed_zero;
  homing_.emplace(one_axis_synchroniser(axis, period_));
  homing_->start(input_.motors);
}

double MotorControl::follow_homing(edp::Synchroniser::Status& status) noexcept {
  DesiredState desired;
  status = homing_->step(input_, desired);
  return regulate(desired.position[0]);
}

}  // namespace mrroc::sim
