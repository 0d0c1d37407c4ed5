#include "canopen/default_value.hpp"

#include <cctype>
#include <cstdlib>
#include <string>

namespace mrroc::canopen {

namespace {

std::string without_blanks(std::string text) {
  std::erase_if(text, [](unsigned char letter) { return std::isspace(letter) != 0; });
  return text;
}

std::optional<std::uint64_t> summand(const std::string& text, NodeId node) {
  if (text == "$NODEID" || text == "$nodeid") return node;
  char* end = nullptr;
  const std::uint64_t value = std::strtoull(text.c_str(), &end, 0);  // also of "-5"
  if (text.empty() || *end != '\0') return {};
  return value;
}

}  // namespace

std::optional<std::int64_t> default_number(const ObjectEntry& entry, NodeId node) {
  std::string rest = without_blanks(entry.default_value);
  std::uint64_t sum = 0;
  for (;;) {
    const std::size_t plus = rest.find('+');
    const auto value = summand(rest.substr(0, plus), node);
    if (!value) return {};
    sum += *value;
    if (plus == std::string::npos) return static_cast<std::int64_t>(sum);
    rest.erase(0, plus + 1);
  }
}

}  // namespace mrroc::canopen
