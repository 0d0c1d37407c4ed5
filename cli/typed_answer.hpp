#pragma once

#include <optional>
#include <string>

#include "config/deployment.hpp"

namespace mrroc::cli {

/// "a number from 0 to 10": what sensor `sensor`, which asks the operator, takes for an answer.
std::string expected_answer(const config::SensorEntry& sensor);

/// A line that the operator has typed as an answer to `sensor`: one number in decimal or scientific notation, blanks
/// around it allowed. Otherwise null, and `refusal` says why and what was expected.
std::optional<double> read_answer(const config::SensorEntry& sensor, const std::string& line, std::string& refusal);

}  // namespace mrroc::cli
