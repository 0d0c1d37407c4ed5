#include "sensors/infrared/infrared_sensor.hpp"

#include <algorithm>
#include <string>

#include "vsp/configuration.hpp"
#include "vsp/parameters.hpp"
#include "vsp/reading_error.hpp"

namespace mrroc::vsp {

namespace {

constexpr std::uint32_t kDistanceStream = 0;
constexpr std::uint32_t kDropoutStream = 1;

std::string metres(double value) { return std::to_string(value).append(" m"); }

}  // namespace

void InfraredSensor::configure(const config::SensorEntry& entry, double /*servo_period*/) {
  max_range_ = number(entry, "max_range");
  dead_zone_ = number(entry, "dead_zone");
  noise_growth_ = number(entry, "noise");
  dropout_ = number(entry, "dropout");
  on_at_ = number(entry, "presence");
  off_beyond_ = on_at_ + number(entry, "hysteresis");
  noise_ = Noise{entry.name};
  presence_ = false;
  hardware_ = {dead_zone_, max_range_};
  if (dead_zone_ >= max_range_) {
    refuse(entry, "dead_zone", metres(dead_zone_), std::string("less than max_range, ").append(metres(max_range_)));
  }
  if (on_at_ < dead_zone_ || off_beyond_ > max_range_) {
    refuse(entry, "presence",
           metres(on_at_).append(" and up to ").append(metres(off_beyond_)).append(" with hysteresis"),
           std::string("both within dead_zone, ")
               .append(metres(dead_zone_))
               .append(", and max_range, ")
               .append(metres(max_range_)));
  }
}

void InfraredSensor::reconfigure(const Message& configuration) {
  take_configuration<InfraredRange, PresenceAt>(configuration, [this](const auto& taken) { apply(taken); });
}

void InfraredSensor::apply(const InfraredRange& range) {
  check_range("InfraredRange", {range.nearest, range.farthest}, hardware_);
  check_configured("InfraredRange", "nearest", range.nearest, hardware_.nearest, on_at_, "m, the presence");
  check_configured("InfraredRange", "farthest", range.farthest, off_beyond_, hardware_.farthest,
                   "m, beyond the presence");
  dead_zone_ = range.nearest;
  max_range_ = range.farthest;
}

void InfraredSensor::apply(const PresenceAt& presence) {
  check_configured("PresenceAt", "distance", presence.distance, dead_zone_, max_range_, "m");
  check_configured("PresenceAt", "hysteresis", presence.hysteresis, 0, max_range_ - presence.distance, "m");
  on_at_ = presence.distance;
  off_beyond_ = presence.distance + presence.hysteresis;
  presence_ = false;
}

void InfraredSensor::track(const RawReading& r) noexcept {
  if (!measurable(r.values[0])) return;
  const std::optional<double> distance = seen(r);
  presence_ = distance && (*distance <= on_at_ || (presence_ && *distance <= off_beyond_));
}

void InfraredSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  const double range = r.values[0];
  if (range < 0 && range != kNothingHit) {
    return report(v, ErrorClass::hardware, ErrorCode::sensor_hardware, "range %g m, expected at least 0 or -1", range);
  }
  if (!measurable(range)) {
    return report(v, ErrorClass::non_fatal, ErrorCode::sensor_out_of_range,
                  "range %g m, expected at least %g m, the dead zone", range, dead_zone_);
  }
  track(r);
  const std::optional<double> distance = seen(r);
  v.values[0] = distance.value_or(max_range_);
  v.values[1] = distance ? 1 : 0;
  v.values[2] = presence_ ? 1 : 0;
}

std::optional<double> InfraredSensor::seen(const RawReading& r) const noexcept {
  const double range = r.values[0];
  const bool lost = noise_.uniform(r.tick, kDropoutStream) < dropout_;
  if (range == kNothingHit || range > max_range_ || lost) return std::nullopt;
  const double deviation = noise_growth_ * range * range;
  const double noise = deviation > 0 ? deviation * noise_.normal(r.tick, kDistanceStream) : 0.0;
  return std::clamp(range + noise, dead_zone_, max_range_);
}

}  // namespace mrroc::vsp
