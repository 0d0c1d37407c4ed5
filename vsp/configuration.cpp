#include "vsp/configuration.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace mrroc::vsp {

namespace {

std::string text_of(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

}  // namespace

void refuse_configuration(std::string_view label, const std::string& what, double value, const std::string& expected) {
  std::string text(label);
  text.append(": ").append(what).append(" ").append(text_of(value)).append(", expected ").append(expected);
  throw NonFatalError(ErrorCode::invalid_argument, text);
}

void check_configured(std::string_view label, const std::string& what, double value, double least, double most,
                      const std::string& unit) {
  if (std::isfinite(value) && value >= least && value <= most) return;
  refuse_configuration(label, what, value,
                       text_of(least).append(" to ").append(text_of(most)).append(" ").append(unit));
}

}  // namespace mrroc::vsp
