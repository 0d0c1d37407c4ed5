#include "config/entries/operator_answer.hpp"

namespace mrroc::config {

bool asks_operator(const SensorEntry& sensor) { return sensor.type == "operator_input" && sensor.source != "replay"; }

Range answers_of(const SensorEntry& sensor) {
  return {.min = sensor.numbers.at("min").at(0), .max = sensor.numbers.at("max").at(0)};
}

bool is_answer(const SensorEntry& sensor, double value) {
  const Range range = answers_of(sensor);
  return value >= range.min && value <= range.max;
}

}  // namespace mrroc::config
