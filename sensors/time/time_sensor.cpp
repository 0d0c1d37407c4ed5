#include "sensors/time/time_sensor.hpp"

#include "sensors/time/time_source.hpp"

namespace mrroc::vsp {

void TimeSensor::configure(const config::SensorEntry& /*entry*/, double servo_period) { servo_period_ = servo_period; }

std::unique_ptr<Source> TimeSensor::open_source(const SourceContext& context) {
  if (context.entry.source == "replay") return nullptr;  // the framework's
  return std::make_unique<TimeSource>();
}

void TimeSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  v.values[0] = (r.values[0] - zero_) * servo_period_;
  v.values[1] = r.values[0];
}

bool TimeSensor::bias(const RawReading& r) noexcept {
  zero_ = r.values[0];
  return true;
}

}  // namespace mrroc::vsp
