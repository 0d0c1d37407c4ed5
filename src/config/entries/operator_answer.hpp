#pragma once

#include <string>

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Whether the readings of this sensor are the operator's answers: type `operator_input`, and not a replayed file.
bool asks_operator(const SensorEntry& sensor);

/// The answers that such a sensor accepts: its parameters `min` and `max`, both included.
Range answers_of(const SensorEntry& sensor);

/// Whether `value` is one of them.
bool is_answer(const SensorEntry& sensor, double value);

}  // namespace mrroc::config
