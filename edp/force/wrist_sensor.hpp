#pragma once

#include <memory>

#include "edp/force/force_sensor.hpp"
#include "vsp/source.hpp"
#include "vsp/wrench_source.hpp"

namespace mrroc::edp {

/// The force/torque sensor of a robot's wrist, read by its EDP: the same raw readings and the same aggregating function
/// as in the sensor's VSP, but with the flange pose of the present tick for the tool's weight and with its own zero.
/// Where the reading is out of range the wrench is the raw one.
class WristSensor final : public ForceSensor {
 public:
  /// Throws ConfigurationError, SystemError(configuration) as the VSP does.
  WristSensor(std::unique_ptr<vsp::WrenchSource> sensor, const vsp::SourceContext& context);

  const Pose& mount() const noexcept override { return mount_; }
  WrenchReading read(Tick tick, const Pose* flange) noexcept override;
  void bias() noexcept override { sensor_->bias(raw_); }
  void carry(const Load& carried) noexcept override { sensor_->carry(carried); }

 private:
  std::unique_ptr<vsp::WrenchSource> sensor_;
  std::unique_ptr<vsp::Source> source_;
  Pose mount_;
  vsp::RawReading raw_;
  RobotState effector_state_;
};

/// The aggregating function of a sensor's type, from its library (`entry.wrench_library`). Throws
/// SystemError(configuration) as `plugin::load`. Main thread.
std::unique_ptr<vsp::WrenchSource> load_wrench_source(const config::SensorEntry& entry);

}  // namespace mrroc::edp
