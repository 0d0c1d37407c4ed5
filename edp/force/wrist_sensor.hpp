#pragma once

#include <memory>

#include "edp/force/force_sensor.hpp"
#include "sensors/force_torque/force_torque_sensor.hpp"
#include "vsp/source.hpp"

namespace mrroc::edp {

/// The force/torque sensor of a robot's wrist, read by its EDP: the same raw readings and the same aggregating function
/// as in the sensor's VSP (sensors/force_torque), but with the flange pose of the present tick for the tool's weight
/// and with its own zero. Where the reading is out of range the wrench is the raw one.
class WristSensor final : public ForceSensor {
 public:
  /// Throws ConfigurationError, SystemError(configuration) as the VSP does.
  explicit WristSensor(const vsp::SourceContext& context);

  const Pose& mount() const noexcept override { return mount_; }
  WrenchReading read(Tick tick, const Pose* flange) noexcept override;
  void bias() noexcept override { sensor_.bias(raw_); }

 private:
  vsp::ForceTorqueSensor sensor_;
  std::unique_ptr<vsp::Source> source_;
  Pose mount_;
  vsp::RawReading raw_;
  RobotState effector_state_;
};

}  // namespace mrroc::edp
