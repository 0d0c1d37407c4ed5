#pragma once

#include <vsp/virtual_sensor.hpp>

namespace mrroc::vsp {

/// place = r / scale.
class GaugeSensor final : public VirtualSensor {
 public:
  std::vector<Channel> channels() const override { return {{"place", "m"}}; }
  std::vector<Channel> raw_channels() const override { return {{"raw", "m"}}; }
  void configure(const config::SensorEntry& entry, double servo_period) override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;

 private:
  double scale_ = 1;
};

}  // namespace mrroc::vsp
