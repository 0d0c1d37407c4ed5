#include "gauge_sensor.hpp"

#include <vsp/parameters.hpp>

namespace mrroc::vsp {

void GaugeSensor::configure(const config::SensorEntry& entry, double /*servo_period*/) {
  scale_ = number(entry, "scale");
}

void GaugeSensor::aggregate(const RawReading& r, SensorReading& v) noexcept { v.values[0] = r.values[0] / scale_; }

}  // namespace mrroc::vsp
