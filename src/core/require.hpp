#pragma once

#include <cmath>
#include <string>

#include "mrroc/errors.hpp"

/// Checks of arguments: each throws NonFatalError(invalid_argument) that names the caller, the argument, its value and
/// what was expected.
namespace mrroc {

inline void require(bool good, const char* caller, const char* what, double value, const char* expected) {
  if (good) return;
  throw NonFatalError(ErrorCode::invalid_argument,
                      std::string{caller} + ": " + what + " " + std::to_string(value) + ", expected " + expected);
}

inline void require_above_zero(const char* caller, const char* what, double value) {
  require(value > 0 && std::isfinite(value), caller, what, value, "a finite number above 0");
}

inline void require_finite(const char* caller, const char* what, double value) {
  require(std::isfinite(value), caller, what, value, "a finite number");
}

inline void require_not_negative(const char* caller, const char* what, double value) {
  require(value >= 0 && std::isfinite(value), caller, what, value, "a finite number of at least 0");
}

}  // namespace mrroc
