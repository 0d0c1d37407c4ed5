#pragma once

#include "vsp/virtual_sensor.hpp"

namespace mrroc::vsp {

/// The deployment's time. r is `tick`, the number of a servo tick, exact below 2^53; v is
///
///     time = (tick - zero) servo_period     s
///     tick                                  unchanged, never shifted
///
/// `bias` makes the present tick zero; until then zero is the deployment's tick 0.
class TimeSensor final : public VirtualSensor {
 public:
  void configure(const config::SensorEntry& entry, double servo_period) override;
  std::unique_ptr<Source> open_source(const SourceContext& context) override;
  void aggregate(const RawReading& r, SensorReading& v) noexcept override;
  bool bias(const RawReading& r) noexcept override;

 private:
  double servo_period_ = 0;
  double zero_ = 0;
};

}  // namespace mrroc::vsp
