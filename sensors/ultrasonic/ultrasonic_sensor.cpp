#include "sensors/ultrasonic/ultrasonic_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "mrroc/sensors/ultrasonic.hpp"
#include "vsp/configuration.hpp"
#include "vsp/parameters.hpp"
#include "vsp/reading_error.hpp"

namespace mrroc::vsp {

namespace {

constexpr std::uint32_t kDistanceStream = 0;
constexpr std::uint32_t kDropoutStream = 1;

}  // namespace

std::vector<Channel> UltrasonicSensor::raw_channels() const {
  if (rays_ == 1) return VirtualSensor::raw_channels();
  std::vector<Channel> channels;
  for (std::size_t i = 0; i < rays_; ++i) channels.push_back({std::string("range_").append(std::to_string(i)), "m"});
  return channels;
}

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
  hardware_ = {dead_zone_, max_range_};
  configure_beam(entry);
}

void UltrasonicSensor::reconfigure(const Message& configuration) {
  take_configuration<UltrasonicRange>(configuration, [this](const UltrasonicRange& range) {
    check_range("UltrasonicRange", {range.nearest, range.farthest}, hardware_);
    dead_zone_ = range.nearest;
    max_range_ = range.farthest;
  });
}

void UltrasonicSensor::configure_beam(const config::SensorEntry& entry) {
  const double rays = number(entry, "rays");
  if (rays != std::floor(rays)) refuse(entry, "rays", std::to_string(rays), "a whole number");
  rays_ = static_cast<std::size_t>(rays);
  beam_ = {number(entry, "beam_angle"), number(entry, "max_incidence")};
  if (rays_ == 1 && beam_.opening > 0) {
    refuse(entry, "beam_angle", std::to_string(beam_.opening).append(" rad of one ray"), "the key 'rays' beside it");
  }
  if (rays_ > 1 && !(beam_.opening > 0)) {
    refuse(entry, "beam_angle", std::string("0 rad of ").append(std::to_string(rays_)).append(" rays"),
           "the full opening of the beam");
  }
  if (rays_ < 3 && beam_.max_incidence < std::numbers::pi / 2) {
    refuse(entry, "max_incidence", std::to_string(rays_).append(" rays, which show no surface's slope"),
           "at least 3 rays");
  }
}

void UltrasonicSensor::aggregate(const RawReading& r, SensorReading& v) noexcept {
  const std::span<const double> ranges{r.values.data(), rays_};
  const auto wrong =
      std::find_if(ranges.begin(), ranges.end(), [](double range) { return range < 0 && range != kNothingHit; });
  if (wrong != ranges.end()) {
    return report(v, ErrorClass::hardware, ErrorCode::sensor_hardware, "range %g m, expected at least 0 or -1", *wrong);
  }
  const double range = nearest_echo(ranges, beam_);
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
