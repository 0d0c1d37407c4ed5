#pragma once

#include <stdexcept>
#include <string_view>

namespace mrroc::cli::trace {

/// A message is not one of a step. `what()` names field, value and what was expected.
class Malformed : public std::runtime_error {
 public:
  Malformed(std::string_view field, std::string_view value, std::string_view expected);
};

}  // namespace mrroc::cli::trace
