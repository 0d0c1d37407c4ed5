#pragma once

#include <memory>
#include <string>

#include "edp/hardware.hpp"

namespace mrroc::edp {

/// A driver whose calls are named (driver_calls.hpp): two stores more in each; otherwise the driver itself.
class GuardedHardware final : public Hardware {
 public:
  GuardedHardware(std::string name, std::unique_ptr<Hardware> hardware)
      : name_(std::move(name)), hardware_(std::move(hardware)) {}
  ~GuardedHardware() override;

  void open() override;
  void enable(bool on) noexcept override;
  bool busy() const noexcept override;
  void reset_fault() noexcept override;
  bool waits() const noexcept override { return hardware_->waits(); }
  bool follows_current() const noexcept override { return hardware_->follows_current(); }
  RobotClock* clock() noexcept override { return hardware_->clock(); }
  void read(Tick tick, HardwareInput& input) noexcept override;
  void set_points(const JointVector& position, const JointVector& velocity) noexcept override;
  void write(Tick tick, const JointVector& current) noexcept override;
  void set_outputs(const ControllerIo& outputs) noexcept override;
  void set_origin(const JointVector& shift) noexcept override;
  bool homes() const noexcept override { return hardware_->homes(); }
  void home(int axis) noexcept override;

 private:
  std::string name_;
  std::unique_ptr<Hardware> hardware_;
};

}  // namespace mrroc::edp
