#pragma once

#include <string>
#include <vector>

#include "cli/trace/line.hpp"

namespace mrroc::cli::trace {

/// What a condition may be worth, as far as it is known.
struct PossibleValues {
  bool may_be_false = true;
  bool may_be_true = true;

  bool is_true() const noexcept { return !may_be_false; }
  bool is_false() const noexcept { return !may_be_true; }
};

/// f_I or f_T from its parts. A trace tells the name of the whole, which is composed of those of its parts, left to
/// right: "a and b", "a or b", "not (a)" (mrroc/condition.hpp). Where `and` and `or` follow each other the name does
/// not tell which binds first: every way to set the brackets is possible. Of a condition with a name of its own
/// (`named`) nothing is known.
PossibleValues value_of_condition(const std::string& name, const std::vector<ConditionEntry>& parts);

/// "a:0 b:1", for people.
std::string text_of_values(const std::vector<ConditionEntry>& parts);

}  // namespace mrroc::cli::trace
