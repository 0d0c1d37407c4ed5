#pragma once

#include <memory>
#include <vector>

#include "edp/hardware.hpp"
#include "faults/fault_plan.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

/// Drives with injected faults: falsifies the values that the real driver reads and writes while a fault is in force.
/// The layers above cannot detect it. It runs in the servo tick and follows its rules.
class InjectedHardware final : public Hardware {
 public:
  /// `parameters` must outlive it. Throws NonFatalError(invalid_argument): a fault of a missing axis.
  InjectedHardware(std::unique_ptr<Hardware> hardware, std::vector<faults::FaultSwitch> faults,
                   const RobotParameters& parameters);

  void open() override { hardware_->open(); }
  void enable(bool on) noexcept override { hardware_->enable(on); }
  void reset_fault() noexcept override { hardware_->reset_fault(); }
  bool busy() const noexcept override { return hardware_->busy(); }
  bool homes() const noexcept override { return hardware_->homes(); }
  void home(int axis) noexcept override { hardware_->home(axis); }
  void set_points(const JointVector& position, const JointVector& velocity) noexcept override {
    hardware_->set_points(position, velocity);
  }
  bool waits() const noexcept override { return hardware_->waits(); }
  bool follows_current() const noexcept override { return hardware_->follows_current(); }
  RobotClock* clock() noexcept override { return hardware_->clock(); }
  void read(Tick tick, HardwareInput& input) noexcept override;
  void write(Tick tick, const JointVector& current) noexcept override;
  void set_outputs(const ControllerIo& outputs) noexcept override { hardware_->set_outputs(outputs); }
  void set_origin(const JointVector& shift) noexcept override { hardware_->set_origin(shift); }

 private:
  void falsify(const faults::InjectedFault& fault, HardwareInput& input) noexcept;

  std::unique_ptr<Hardware> hardware_;
  std::vector<faults::FaultSwitch> faults_;
  const RobotParameters& parameters_;
  JointVector last_motors_;  ///< as given to the servo in the tick before
  bool read_ = false;
};

}  // namespace mrroc::edp
