#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>
#include <type_traits>

namespace mrroc::command {

/// The error of `text` as a number from `min` to `max`, with what was expected; empty when it is valid. Decimal digits,
/// for a real number with a point and an exponent; finite.
template <class Number>
std::string number_problem(std::string text, Number min, Number max) {
  const auto shown = [](Number value) {
    char digits[64];
    return std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
  };
  Number value{};
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  bool good = error == std::errc{} && stop == end && *begin != '+' && value >= min && value <= max;
  if constexpr (std::is_floating_point_v<Number>) good = good && std::isfinite(value);
  if (good) return "";
  const std::string noun = std::is_floating_point_v<Number> ? "a number" : "an integer";
  const bool open = max == std::numeric_limits<Number>::max();
  return "'" + text + "', expected " + noun +
         (open ? " of at least " + shown(min) : " from " + shown(min) + " to " + shown(max));
}

/// Adds the option `name` whose value is a number from `min` to `max`; another value is a usage error that names the
/// option, the value and the range. `Target` is Number or std::optional<Number>.
template <class Number, class Target>
CLI::Option* add_number(CLI::App& app, const std::string& name, Target& target, Number min, Number max,
                        const std::string& description) {
  return app.add_option(name, target, description)
      ->check(
          CLI::Validator([min, max](const std::string& text) { return number_problem<Number>(text, min, max); }, ""));
}

}  // namespace mrroc::command
