#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cli/trace/line.hpp"

namespace mrroc::cli::trace {

/// A line does not follow the format. `what()` names field, value and what was expected.
class Malformed : public std::runtime_error {
 public:
  Malformed(std::string_view field, std::string_view value, std::string_view expected);
};

/// Reads a line field by field, from left to right. Throws Malformed for a field that cannot be read.
class Fields {
 public:
  explicit Fields(std::string_view text) : rest_(text) {}

  bool at_end() const noexcept { return rest_.empty(); }
  bool next_is(std::string_view text) const noexcept { return rest_.starts_with(text); }
  /// Skips `text` when it comes next.
  bool take(std::string_view text) noexcept;
  /// Skips `text`, which must come next; `field` is for the message.
  void expect(std::string_view text, std::string_view field);
  /// All up to the next blank, or to the end.
  std::string_view word() noexcept;
  /// All text before the first of `ends`. Throws when none of them follows.
  std::string_view up_to(std::initializer_list<std::string_view> ends, std::string_view field);

  /// The next word, converted to the required type.
  std::string name(std::string_view field);
  std::uint64_t count(std::string_view field);
  /// `size` values, any number of them when 0.
  Numbers finite_numbers(std::string_view field, std::size_t size);
  Numbers numbers(std::string_view field);

 private:
  std::string_view rest_;
};

/// The values of "0.1,-2e-05,nan"; empty for "". Throws Malformed.
Numbers parse_numbers(std::string_view text, std::string_view field);
std::uint64_t parse_count(std::string_view text, std::string_view field);

}  // namespace mrroc::cli::trace
