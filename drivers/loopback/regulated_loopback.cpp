#include "drivers/loopback/regulated_loopback.hpp"

#include <cmath>
#include <numbers>

#include "mrroc/errors.hpp"

namespace mrroc::edp {

RegulatedLoopback::RegulatedLoopback(const RobotModel& model, double period, bool synchronised)
    : drives_(model.parameters().drives),
      period_(period),
      rate_(2 * std::numbers::pi * drives_.bandwidth),
      decay_(std::exp(-rate_ * period)),
      encoders_(model.parameters(), synchronised) {
  if (model.joints_to_motors(model.parameters().home, shafts_) != ErrorCode::none)
    throw SystemError(ErrorCode::configuration, "robot " + model.parameters().type + ": home is out of reach");
  for (const double angle : shafts_) motors_.push_back({angle, 0, angle, 0});
}

void RegulatedLoopback::enable(bool on) noexcept {
  enabled_ = on;
  for (Motor& motor : motors_) motor = {motor.angle, 0, motor.angle, 0};
}

void RegulatedLoopback::step(Motor& motor) const noexcept {
  const double error = motor.target - motor.angle, lag = motor.rate - motor.velocity;
  double next_error = 0, next_lag = 0;
  if (drives_.interface == DriveParameters::Interface::position) {
    const double sum = lag + rate_ * error;
    next_error = (error + sum * period_) * decay_;
    next_lag = (lag - rate_ * sum * period_) * decay_;
  } else {
    next_error = error + lag * (1 - decay_) / rate_;
    next_lag = lag * decay_;
  }
  motor.target += motor.rate * period_;
  motor.angle = motor.target - next_error;
  motor.velocity = motor.rate - next_lag;
}

void RegulatedLoopback::read(Tick tick, HardwareInput& input) noexcept {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    for (Tick k = last_; enabled_ && k < tick; ++k) step(motors_[i]);
    shafts_[static_cast<Eigen::Index>(i)] = motors_[i].angle;
  }
  last_ = tick;
  encoders_.read(shafts_, input);
  input.current.setZero(shafts_.size());
  input.inputs = terminals_;
  input.fault = ErrorCode::none;
}

void RegulatedLoopback::set_points(const JointVector& position, const JointVector& velocity) noexcept {
  if (!enabled_) return;
  const JointVector targets = encoders_.shafts(position);
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    Motor& motor = motors_[i];
    motor.target = targets[static_cast<Eigen::Index>(i)];
    motor.rate = velocity[static_cast<Eigen::Index>(i)];
    if (drives_.interface == DriveParameters::Interface::velocity)
      motor.rate += drives_.position_gain * (motor.target - motor.angle);
  }
}

}  // namespace mrroc::edp
