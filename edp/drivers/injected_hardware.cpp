#include "edp/drivers/injected_hardware.hpp"

#include <limits>

namespace mrroc::edp {

using faults::Kind;

InjectedHardware::InjectedHardware(std::unique_ptr<Hardware> hardware, std::vector<faults::FaultSwitch> faults,
                                   const RobotParameters& parameters)
    : hardware_(std::move(hardware)), faults_(std::move(faults)), parameters_(parameters) {
  faults::check_axes(faults_, parameters);
}

void InjectedHardware::read(Tick tick, HardwareInput& input) noexcept {
  hardware_->read(tick, input);
  for (const faults::FaultSwitch& each : faults_)
    if (each.on(tick)) falsify(each.fault(), input);
  last_motors_ = input.motors;
  read_ = true;
}

void InjectedHardware::falsify(const faults::InjectedFault& fault, HardwareInput& input) noexcept {
  const auto axis = static_cast<Eigen::Index>(fault.axis);
  switch (fault.kind) {
    case Kind::fault:
      input.fault = ErrorCode::drive_fault;
      break;
    case Kind::silence:
      input.fault = ErrorCode::hardware_silent;
      if (read_) input.motors = last_motors_;
      break;
    case Kind::unreference:
      input.synchronised = false;
      break;
    case Kind::jump:
      input.motors[axis] += fault.value;
      break;
    case Kind::freeze:
      if (read_) input.motors[axis] = last_motors_[axis];
      break;
    case Kind::nan:
      input.motors[axis] = std::numeric_limits<double>::quiet_NaN();
      break;
    case Kind::overload:
      input.current[axis] = fault.value * parameters_.axes[fault.axis].current_max;
      break;
    default:
      break;
  }
}

void InjectedHardware::write(Tick tick, const JointVector& current) noexcept {
  JointVector falsified = current;
  for (const faults::FaultSwitch& each : faults_) {
    const auto axis = static_cast<Eigen::Index>(each.fault().axis);
    if (!each.on(tick)) continue;
    if (each.fault().kind == Kind::disconnect) falsified[axis] = 0;
    if (each.fault().kind == Kind::runaway) falsified[axis] = parameters_.axes[each.fault().axis].current_max;
  }
  hardware_->write(tick, falsified);
}

}  // namespace mrroc::edp
