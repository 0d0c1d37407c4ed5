#include "edp/drivers/guarded_hardware.hpp"

#include "edp/drivers/driver_calls.hpp"

namespace mrroc::edp {

GuardedHardware::~GuardedHardware() {
  const DriverCall call("its destructor");
  hardware_.reset();
}

void GuardedHardware::open() {
  call_driver(name_, "open", [this] { hardware_->open(); });
}

void GuardedHardware::enable(bool on) noexcept {
  const DriverCall call("enable");
  hardware_->enable(on);
}

bool GuardedHardware::busy() const noexcept {
  const DriverCall call("busy");
  return hardware_->busy();
}

void GuardedHardware::reset_fault() noexcept {
  const DriverCall call("reset_fault");
  hardware_->reset_fault();
}

void GuardedHardware::read(Tick tick, HardwareInput& input) noexcept {
  const DriverCall call("read");
  hardware_->read(tick, input);
}

void GuardedHardware::set_points(const JointVector& position, const JointVector& velocity) noexcept {
  const DriverCall call("set_points");
  hardware_->set_points(position, velocity);
}

void GuardedHardware::write(Tick tick, const JointVector& current) noexcept {
  const DriverCall call("write");
  hardware_->write(tick, current);
}

void GuardedHardware::set_outputs(const ControllerIo& outputs) noexcept {
  const DriverCall call("set_outputs");
  hardware_->set_outputs(outputs);
}

void GuardedHardware::set_origin(const JointVector& shift) noexcept {
  const DriverCall call("set_origin");
  hardware_->set_origin(shift);
}

void GuardedHardware::home(int axis) noexcept {
  const DriverCall call("home");
  hardware_->home(axis);
}

}  // namespace mrroc::edp
