#pragma once

#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// Encoder of a conveyor's belt. r is `travel` (m, since the start) and `speed` (m/s); v is
///
///     position = resolution round(travel / resolution) - zero     m
///     velocity = speed                                            m/s
///
/// `bias` makes the present position zero; until then zero is the belt's position at the start. With `resolution` 0
/// nothing is rounded.
class ConveyorEncoderSensor final : public VirtualSensor {
 public:
  void configure(const config::SensorEntry& entry, double servo_period) override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;
  bool bias(const RawReading& r) noexcept override;

 private:
  double counted(double travel) const noexcept;
  double resolution_ = 0;
  double zero_ = 0;
};

}  // namespace mrroc::vsp
