#include "drivers/loopback/loopback_hardware.hpp"

#include <algorithm>
#include <cmath>

#include "mrroc/errors.hpp"

namespace mrroc::edp {

LoopbackHardware::LoopbackHardware(const RobotModel& model, double period, bool synchronised)
    : encoders_(model.parameters(), synchronised), period_(period) {
  JointVector home;
  if (model.joints_to_motors(model.parameters().home, home) != ErrorCode::none)
    throw SystemError(ErrorCode::configuration, "robot " + model.parameters().type + ": home is out of reach");
  for (const AxisParameters& axis : model.parameters().axes) {
    if (!(axis.rotor_inertia > 0) || !(axis.viscous_friction > 0) || !(axis.encoder_increments > 0))
      throw SystemError(ErrorCode::configuration,
                        "axis " + axis.name + ": rotor_inertia, viscous_friction, encoder_increments must be above 0");
    Motor motor{};
    motor.time_constant = axis.rotor_inertia / axis.viscous_friction;
    motor.decay = std::exp(-period / motor.time_constant);
    motor.final_per_ampere = axis.torque_constant / axis.viscous_friction;
    motor.current_max = axis.current_max;
    motor.angle = home[static_cast<Eigen::Index>(motors_.size())];
    motors_.push_back(motor);
  }
}

void LoopbackHardware::enable(bool on) noexcept {
  enabled_ = on;
  for (Motor& motor : motors_) motor.velocity = motor.current = 0;
}

void LoopbackHardware::read(Tick tick, HardwareInput& input) noexcept {
  const auto count = static_cast<Eigen::Index>(motors_.size());
  shafts_.resize(count);
  input.current.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    Motor& motor = motors_[static_cast<std::size_t>(i)];
    const double final_velocity = motor.final_per_ampere * motor.current;
    for (Tick k = last_; enabled_ && k < tick; ++k) {
      const double excess = motor.velocity - final_velocity;
      motor.angle += final_velocity * period_ + excess * (1.0 - motor.decay) * motor.time_constant;
      motor.velocity = final_velocity + excess * motor.decay;
    }
    shafts_[i] = motor.angle;
    input.current[i] = motor.current;
  }
  last_ = tick;
  encoders_.read(shafts_, input);
  input.inputs = terminals_;
  input.fault = ErrorCode::none;
}

void LoopbackHardware::write(Tick, const JointVector& current) noexcept {
  for (std::size_t i = 0; i < motors_.size(); ++i)
    motors_[i].current =
        enabled_ ? std::clamp(current[static_cast<Eigen::Index>(i)], -motors_[i].current_max, motors_[i].current_max)
                 : 0.0;
}

}  // namespace mrroc::edp
