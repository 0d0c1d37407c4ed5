#include "sensors/conveyor_encoder/conveyor_encoder_sensor.hpp"

#include <cmath>

#include "vsp/parameters.hpp"

namespace mrroc::vsp {

void ConveyorEncoderSensor::configure(const config::SensorEntry& entry, double /*servo_period*/) {
  resolution_ = number(entry, "resolution");
}

void ConveyorEncoderSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  v.values[0] = counted(r.values[0]) - zero_;
  v.values[1] = r.values[1];
}

bool ConveyorEncoderSensor::bias(const RawReading& r) noexcept {
  zero_ = counted(r.values[0]);
  return true;
}

double ConveyorEncoderSensor::counted(double travel) const noexcept {
  return resolution_ > 0 ? resolution_ * std::round(travel / resolution_) : travel;
}

}  // namespace mrroc::vsp
