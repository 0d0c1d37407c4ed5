#include "mrroc/sensors/ultrasonic.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "mrroc/errors.hpp"

namespace mrroc {

namespace {

std::string condition_name(const Ultrasonic& sensor, double metres) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " closer than %g m", metres);
  return sensor.name() + text.data();
}

}  // namespace

Ultrasonic::Ultrasonic(Task& task, const std::string& name) : Sensor(task, name, "ultrasonic") {}

Closer::Closer(const Ultrasonic& sensor, double metres)
    : Condition(condition_name(sensor, metres)), sensor_(&sensor), metres_(metres) {
  if (!(metres > 0) || !std::isfinite(metres)) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "Closer " + std::to_string(metres) + " m, expected a finite distance above 0");
  }
}

}  // namespace mrroc
