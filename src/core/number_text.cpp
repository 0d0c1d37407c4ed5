#include "core/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/shown_text.hpp"

namespace mrroc::core {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Of a decimal number with a decimal exponent: the power of ten of its first digit that is not 0. The exponent may
/// have more digits than a number holds.
double power_of_ten(std::string_view text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::string_view digits = text.substr(0, e);
  double exponent = 0;
  const bool negative = e + 1 < text.size() && text[e + 1] == '-';
  for (const char c : text.substr(e))
    if (is_digit(c)) exponent = std::min(1e9, 10 * exponent + (c - '0'));
  const auto point = static_cast<double>(std::min(digits.find('.'), digits.size()));
  const std::size_t first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return -std::numeric_limits<double>::infinity();
  return (negative ? -exponent : exponent) + point - static_cast<double>(first);
}

enum class Beyond { none, least, greatest };

struct Parsed {
  std::optional<double> value;  ///< nothing: not a number
  Beyond beyond = Beyond::none;
};

Parsed parse(std::string_view text) noexcept {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  if (text.find('(') != std::string_view::npos) return {};  // nan(payload)
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  if (last != end || error == std::errc::invalid_argument) return {};
  if (error != std::errc::result_out_of_range) return {value};
  const double zero = text.front() == '-' ? -0.0 : 0.0;
  return {zero, power_of_ten(text) > 0 ? Beyond::greatest : Beyond::least};
}

}  // namespace

std::optional<double> to_double(std::string_view text) noexcept {
  const Parsed parsed = parse(text);
  if (parsed.beyond == Beyond::greatest) return {};
  return parsed.value;
}

bool is_too_large(std::string_view text) noexcept { return parse(text).beyond == Beyond::greatest; }

std::optional<double> to_finite(std::string_view text) noexcept {
  const auto value = to_double(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::uint64_t> to_literal(std::string_view text) noexcept {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  int base = 10;
  if (text.size() > 2 && text[0] == '0' && (text[1] == 'x' || text[1] == 'X')) {
    base = 16;
    text.remove_prefix(2);
  } else if (text.size() > 1 && text[0] == '0') {
    base = 8;
  }
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value, base);
  if (error != std::errc{} || last != end) return {};
  return negative ? 0 - value : value;
}

std::string hexadecimal(std::uint64_t value) {
  std::string text(16, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, value >>= 4) *digit = "0123456789abcdef"[value & 15U];
  return text;
}

std::string hexadecimal(std::span<const std::byte> bytes) {
  std::string text;
  text.reserve(2 * bytes.size());
  for (const std::byte byte : bytes) {
    text += "0123456789abcdef"[std::to_integer<unsigned>(byte) >> 4];
    text += "0123456789abcdef"[std::to_integer<unsigned>(byte) & 15U];
  }
  return text;
}

std::optional<std::vector<std::byte>> bytes_of_hexadecimal(std::string_view text) {
  if (text.size() % 2 != 0) return std::nullopt;
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 2);
  for (; !text.empty(); text.remove_prefix(2)) {
    std::uint8_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + 2, value, 16);
    if (error != std::errc{} || end != text.data() + 2) return std::nullopt;
    bytes.push_back(std::byte{value});
  }
  return bytes;
}

std::string number_problem(std::string_view text) {
  if (text.empty()) return "is empty";
  if (const auto odd = odd_character(text)) return "has " + odd->text + " at character " + std::to_string(odd->column);
  std::string point{text};
  std::replace(point.begin(), point.end(), ',', '.');
  if (point != text && to_double(point)) return "has a decimal comma";
  return "is not a number";
}

}  // namespace mrroc::core
