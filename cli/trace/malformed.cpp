#include "cli/trace/malformed.hpp"

#include <string>

#include "core/shown_text.hpp"

namespace mrroc::cli::trace {

namespace {

constexpr std::size_t kShown = 60;  // characters of a value in a message

std::string message(std::string_view field, std::string_view value, std::string_view expected) {
  std::string text{field};
  text.append(": '").append(core::shown(value.substr(0, kShown))).append(value.size() > kShown ? "..." : "");
  return text.append("', expected ").append(expected);
}

}  // namespace

Malformed::Malformed(std::string_view field, std::string_view value, std::string_view expected)
    : std::runtime_error(message(field, value, expected)) {}

}  // namespace mrroc::cli::trace
