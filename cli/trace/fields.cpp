#include "cli/trace/fields.hpp"

#include <cmath>

#include "core/number_text.hpp"
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

bool Fields::take(std::string_view text) noexcept {
  if (!next_is(text)) return false;
  rest_.remove_prefix(text.size());
  return true;
}

void Fields::expect(std::string_view text, std::string_view field) {
  if (!take(text)) throw Malformed(field, rest_, std::string{"'"}.append(text).append("'"));
}

std::string_view Fields::word() noexcept {
  const std::string_view found = rest_.substr(0, rest_.find(' '));
  rest_.remove_prefix(found.size());
  return found;
}

std::string_view Fields::up_to(std::initializer_list<std::string_view> ends, std::string_view field) {
  std::size_t first = std::string_view::npos;
  for (const std::string_view end : ends) first = std::min(first, rest_.find(end));
  if (first == std::string_view::npos)
    throw Malformed(field, rest_, std::string{"a text with '"}.append(*ends.begin()).append("' behind it"));
  const std::string_view found = rest_.substr(0, first);
  rest_.remove_prefix(first);
  return found;
}

std::string Fields::name(std::string_view field) {
  const std::string_view found = word();
  if (found.empty()) throw Malformed(field, found, "a name");
  return std::string{found};
}

std::uint64_t Fields::count(std::string_view field) { return parse_count(word(), field); }

Numbers Fields::numbers(std::string_view field) { return parse_numbers(word(), field); }

Numbers Fields::finite_numbers(std::string_view field, std::size_t size) {
  const std::string_view text = word();
  Numbers found = parse_numbers(text, field);
  if (size != 0 && found.size() != size) throw Malformed(field, text, std::to_string(size) + " numbers");
  for (const double value : found)
    if (!std::isfinite(value)) throw Malformed(field, text, "finite numbers");
  return found;
}

Numbers parse_numbers(std::string_view text, std::string_view field) {
  Numbers found;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t size = std::min(rest.find(','), rest.size());
    const auto value = core::to_double(rest.substr(0, size));
    if (!value || size + 1 == rest.size()) throw Malformed(field, text, "numbers with commas between");
    found.push_back(*value);
    rest.remove_prefix(std::min(size + 1, rest.size()));
  }
  return found;
}

std::uint64_t parse_count(std::string_view text, std::string_view field) {
  const auto value = core::to_whole<std::uint64_t>(text);
  if (!value) throw Malformed(field, text, "a whole number, not negative");
  return *value;
}

}  // namespace mrroc::cli::trace
