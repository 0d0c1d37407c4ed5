#pragma once

#include <string>
#include <vector>

#include "cli/trace/line.hpp"

namespace mrroc::cli::trace {

/// The possible values of a condition, as far as they are known.
struct PossibleValues {
  bool may_be_false = true;
  bool may_be_true = true;

  bool is_true() const noexcept { return !may_be_false; }
  bool is_false() const noexcept { return !may_be_true; }
};

/// f_I or f_T from its parts. A trace has the name of the whole condition, composed of those of its parts, left to
/// right: "a and b", "a or b", "not (a)" (mrroc/condition.hpp). Where `and` and `or` follow each other the name does
/// not show which binds first: every placement of the brackets is possible. The value of a condition with its own name
/// (`named`) is unknown.
PossibleValues value_of_condition(const std::string& name, const std::vector<ConditionEntry>& parts);

/// "a:0 b:1", for messages.
std::string text_of_values(const std::vector<ConditionEntry>& parts);

}  // namespace mrroc::cli::trace
