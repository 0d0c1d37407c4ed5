#include "config/text/message_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/shown_text.hpp"

namespace mrroc::config {

namespace {

constexpr std::size_t kQuotedLength = 60;

bool starts_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

std::string bounded(const std::string& noun, const std::string& min, const std::string& max) {
  if (min.empty() && max.empty()) return noun;
  if (max.empty()) return noun + " of at least " + min;
  if (min.empty()) return noun + " of at most " + max;
  return noun + " from " + min + " to " + max;
}

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> buffer;
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general);
  return {buffer.data(), end};
}

std::string in_quotes(std::string_view text) {
  const bool cut = text.size() > kQuotedLength;
  std::size_t length = cut ? kQuotedLength : text.size();
  while (cut && length > 0 && !starts_character(text[length])) --length;  // no partial UTF-8 character
  std::string result = "'";
  result += core::shown(text.substr(0, length));
  return result += cut ? "...'" : "'";
}

std::string alternatives(const std::vector<std::string>& choices) {
  if (choices.empty()) return "nothing";
  std::string result = in_quotes(choices.front());
  for (std::size_t i = 1; i < choices.size(); ++i)
    result += (i + 1 == choices.size() ? " or " : ", ") + in_quotes(choices[i]);
  return result;
}

std::string expected_number(Range range) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return bounded("a number", range.min == -infinity ? "" : number_text(range.min),
                 range.max == infinity ? "" : number_text(range.max));
}

std::string expected_integer(std::int64_t min, std::int64_t max) {
  using Limits = std::numeric_limits<std::int64_t>;
  return bounded("an integer", min == Limits::min() ? "" : std::to_string(min),
                 max == Limits::max() ? "" : std::to_string(max));
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // rows of the table of distances between the prefixes of a and b: of i - 2, i - 1 and i letters of a
  std::vector<std::size_t> older, before(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) before[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({before[j] + 1, now[j - 1] + 1, before[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], older[j - 2] + 1);
    }
    older = before;
    before = now;
  }
  return before[b.size()];
}

std::string nearest(std::string_view word, const std::vector<std::string>& words) {
  std::string best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const auto& candidate : words) {
    const std::size_t allowed = std::min(candidate.size() - 1, std::max<std::size_t>(1, candidate.size() / 3));
    if (word.size() > candidate.size() + allowed) continue;
    const std::size_t distance = edit_distance(word, candidate);
    if (distance > allowed || distance >= least) continue;
    best = candidate;
    least = distance;
  }
  return best;
}

}  // namespace mrroc::config
