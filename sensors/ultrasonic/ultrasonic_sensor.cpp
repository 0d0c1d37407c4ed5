#include "sensors/ultrasonic/ultrasonic_sensor.hpp"

#include <algorithm>
#include <string>

#include "vsp/parameters.hpp"
#include "vsp/reading_error.hpp"

namespace mrroc::vsp {

namespace {

constexpr double kNothingHit = -1;
constexpr std::uint32_t kDistanceStream = 0;
constexpr std::uint32_t kDropoutStream = 1;

}  // namespace

void UltrasonicSensor::configure(const config::SensorEntry& entry, double /*servo_period*/) {
  max_range_ = number(entry, "max_range");
  dead_zone_ = number(entry, "dead_zone");
  noise_deviation_ = number(entry, "noise");
  dropout_ = number(entry, "dropout");
  noise_ = Noise{entry.name};
  if (dead_zone_ >= max_range_) {
    refuse(entry, "dead_zone", std::to_string(dead_zone_) + " m",
           "less than max_range, " + std::to_string(max_range_) + " m");
  }
}

void UltrasonicSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  const double range = r.values[0];
  if (range < 0 && range != kNothingHit) {
    return report(v, ErrorClass::hardware, ErrorCode::sensor_hardware, "range %g m, expected at least 0 or -1", range);
  }
  const bool hit = range >= 0 && range <= max_range_;
  const bool lost = noise_.uniform(r.tick, kDropoutStream) < dropout_;
  if (!hit || lost) {
    v.values[0] = max_range_;
    v.values[1] = 0;
    return;
  }
  if (range < dead_zone_) {
    return report(v, ErrorClass::non_fatal, ErrorCode::sensor_out_of_range,
                  "range %g m, expected at least %g m, the dead zone", range, dead_zone_);
  }
  const double noise = noise_deviation_ > 0 ? noise_deviation_ * noise_.normal(r.tick, kDistanceStream) : 0.0;
  v.values[0] = std::clamp(range + noise, dead_zone_, max_range_);
  v.values[1] = 1;
}

}  // namespace mrroc::vsp
