#pragma once

#include <optional>
#include <string>

#include "links/wire/operator_messages.hpp"

namespace mrroc::process {

/// "a number from 0 to 10", "yes or no", "'left' or 'right'": the answers that `question` accepts.
std::string expected_answer(const links::OperatorQuestion& question);

/// Whether `value` is one of them: a number within its limits, 1 or 0 for yes or no, the index of a choice.
bool is_answer(const links::OperatorQuestion& question, double value);

/// A line that the operator has typed as an answer to `question`, blanks around it allowed: one number in decimal or
/// scientific notation; yes or no, or y or n; one of the choices, or its number from 1. Otherwise null, and `refusal`
/// contains the reason and what was expected.
std::optional<double> read_answer(const links::OperatorQuestion& question, const std::string& line,
                                  std::string& refusal);

}  // namespace mrroc::process
