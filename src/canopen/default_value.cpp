#include "canopen/default_value.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "can/frame.hpp"
#include "canopen/eds_sections.hpp"
#include "core/number_text.hpp"
#include "core/text_lines.hpp"

namespace mrroc::canopen {

namespace {

/// constant + nodes * node number, modulo 2^64.
struct Sum {
  std::uint64_t constant = 0;
  std::uint64_t nodes = 0;
  std::uint64_t at(NodeId node) const { return constant + nodes * node; }
};

/// Nothing: not such a number.
std::optional<Sum> to_sum(std::string_view text) {
  Sum sum;
  text = core::trimmed(text);
  for (bool first = true; first || !text.empty(); first = false) {
    const bool sign = text.starts_with('+') || text.starts_with('-');
    if (!first && !sign) return {};
    const std::uint64_t factor = text.starts_with('-') ? ~std::uint64_t{0} : 1;  // -1
    if (sign) text = core::trimmed(text.substr(1));
    const std::size_t end = std::min(text.find_first_of("+-"), text.size());
    const std::string_view term = core::trimmed(text.substr(0, end));
    text.remove_prefix(end);
    if (small_letters(term) == "$nodeid") {
      sum.nodes += factor;
      continue;
    }
    const auto literal = core::to_literal(term);
    if (!literal) return {};
    sum.constant += factor * *literal;
  }
  return sum;
}

/// Whether the bits of a number of 64 bits, as signed or unsigned, fit a type.
bool fits(std::uint64_t value, DataType type) {
  if (type == DataType::boolean) return value <= 1;
  const std::size_t bits = 8 * size_of(type);
  if (bits == 64) return true;
  const std::int64_t least_signed = std::numeric_limits<std::int64_t>::min() >> (64 - bits);
  const auto as_signed = static_cast<std::int64_t>(value);
  return value < std::uint64_t{1} << bits || (as_signed < 0 && as_signed >= least_signed);
}

bool has_whole_numbers(DataType type) { return size_of(type) != 0 && type != DataType::real32; }

/// Without a comment that touches the number.
std::string_view number_in(std::string_view text) { return core::trimmed(text.substr(0, text.find(';'))); }

std::optional<std::uint64_t> whole_number(std::string_view text, DataType type, NodeId node) {
  text = number_in(text);
  if (type == DataType::boolean) {
    const std::string word = small_letters(text);
    if (word == "true" || word == "false") return word == "true" ? 1 : 0;
  }
  const auto sum = to_sum(text);
  return sum && fits(sum->at(node), type) ? std::optional(sum->at(node)) : std::nullopt;
}

/// A decimal number, or the bits of a float as a hexadecimal one, as some makers' tools write them. A zero may also be
/// written as a whole number.
std::optional<double> real_number(std::string_view text) {
  text = number_in(text);
  const auto value = core::to_finite(text);
  if (value && std::abs(*value) <= std::numeric_limits<float>::max()) return value;
  const auto whole = core::to_literal(text);
  if (value || !whole || *whole > std::numeric_limits<std::uint32_t>::max()) return {};
  const bool bits = text.starts_with("0x") || text.starts_with("0X");
  const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(*whole));
  return *whole == 0 || (bits && std::isfinite(number)) ? std::optional<double>(number) : std::nullopt;
}

const std::string& configured(const ObjectEntry& entry) {
  return entry.parameter_value.empty() ? entry.default_value : entry.parameter_value;
}

std::optional<std::int64_t> number(const std::string& text, DataType type, NodeId node) {
  if (text.empty() || !has_whole_numbers(type)) return {};
  const auto value = whole_number(text, type, node);
  if (!value) throw std::invalid_argument("'" + text + "', expected " + expected_value(text, type));
  const std::size_t size = size_of(type);
  const std::uint64_t bits = size == 8 ? *value : *value & ((std::uint64_t{1} << 8 * size) - 1);
  return is_signed(type) ? can::sign_extended(bits, size) : static_cast<std::int64_t>(bits);
}

}  // namespace

std::string expected_value(std::string_view text, DataType type) {
  if (text.empty() || size_of(type) == 0) return "";
  if (type == DataType::real32)
    return real_number(text) ? "" : "a decimal number of 32 bits, such as -0.25, or its bits, as 0xBE800000";
  if (whole_number(text, type, 1) && whole_number(text, type, kMaxNode)) return "";
  if (type == DataType::boolean) return "0 or 1";
  return "a number of " + std::to_string(8 * size_of(type)) + " bits such as 384, 0x180 or $NODEID+0x180";
}

std::optional<std::int64_t> default_number(const ObjectEntry& entry, NodeId node) {
  return number(entry.default_value, entry.type, node);
}

std::optional<std::int64_t> configured_number(const ObjectEntry& entry, NodeId node) {
  return number(configured(entry), entry.type, node);
}

std::vector<std::uint8_t> configured_bytes(const ObjectEntry& entry, NodeId node) {
  const std::string& text = configured(entry);
  if (entry.type == DataType::visible_string) return {text.begin(), text.end()};
  std::vector<std::uint8_t> bytes(size_of(entry.type));
  std::uint64_t value = 0;
  if (entry.type == DataType::real32)
    value = std::bit_cast<std::uint32_t>(static_cast<float>(real_number(text).value_or(0)));
  else
    value = static_cast<std::uint64_t>(configured_number(entry, node).value_or(0));
  can::put(bytes, 0, bytes.size(), value);
  return bytes;
}

}  // namespace mrroc::canopen
