#include "language/limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace mrroc {
namespace {

constexpr int kFewestDigits = 6, kAllDigits = 17;

double finite_magnitude(double limit) noexcept { return std::isfinite(limit) ? std::abs(limit) : 0; }

}  // namespace

double position_tolerance(double min, double max) noexcept {
  return kLimitRounding * std::max({1.0, finite_magnitude(min), finite_magnitude(max)});
}

bool exceeds(double value, double limit, double rounding) noexcept {
  return !(std::abs(value) <= limit * (1 + rounding));
}

int digits_to_differ(double value, double limit) noexcept {
  for (int digits = kFewestDigits; digits < kAllDigits; ++digits) {
    std::array<char, 32> a, b;
    std::snprintf(a.data(), a.size(), "%.*g", digits, value);
    std::snprintf(b.data(), b.size(), "%.*g", digits, limit);
    if (std::strcmp(a.data(), b.data()) != 0) return digits;
  }
  return value == limit ? kFewestDigits : kAllDigits;
}

int digits_to_differ(double value, double min, double max) noexcept {
  return std::max(digits_to_differ(value, min), digits_to_differ(value, max));
}

std::string number_text(double value, double limit) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits_to_differ(value, limit), value);
  return text.data();
}

std::string range_text(double value, double min, double max) {
  const int digits = digits_to_differ(value, min, max);
  std::array<char, 120> text;
  std::snprintf(text.data(), text.size(), "%.*g, expected %.*g to %.*g", digits, value, digits, min, digits, max);
  return text.data();
}

}  // namespace mrroc
