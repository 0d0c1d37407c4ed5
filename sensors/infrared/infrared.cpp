#include "mrroc/sensors/infrared.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "mrroc/errors.hpp"

namespace mrroc {

namespace {

std::string condition_name(const Infrared& sensor, double metres) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " nearer than %g m", metres);
  return sensor.name() + text.data();
}

}  // namespace

Infrared::Infrared(Task& task, const std::string& name) : Sensor(task, name, "infrared") {}

Presence::Presence(const Infrared& sensor) : Condition(sensor.name() + " presence"), sensor_(&sensor) {}

Nearer::Nearer(const Infrared& sensor, double metres)
    : Condition(condition_name(sensor, metres)), sensor_(&sensor), metres_(metres) {
  if (!(metres > 0) || !std::isfinite(metres)) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "Nearer " + std::to_string(metres) + " m, expected a finite distance above 0");
  }
}

}  // namespace mrroc
