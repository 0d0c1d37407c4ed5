#include "core/text_lines.hpp"

#include <algorithm>

#include "core/shown_text.hpp"

namespace mrroc::core {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"sv;
constexpr std::string_view kBlanks = " \t"sv;
constexpr char kDosEnd = '\x1A';

/// "UTF-16" or "UTF-32" when the first line of a file has that encoding: it has its mark, or every other byte of its
/// first two characters is 0.
std::string wide_encoding(std::string_view raw) {
  if (raw.starts_with("\xFF\xFE\0\0"sv) || raw.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (raw.starts_with("\xFF\xFE"sv) || raw.starts_with("\xFE\xFF"sv)) return "UTF-16";
  const bool little = raw.size() >= 4 && raw[0] != 0 && raw[1] == 0 && raw[2] != 0 && raw[3] == 0;
  const bool big = raw.size() >= 4 && raw[0] == 0 && raw[1] != 0 && raw[2] == 0 && raw[3] != 0;
  return little || big ? "UTF-16" : "";
}

std::size_t column_of(std::string_view line, std::size_t place) {
  return 1 + static_cast<std::size_t>(std::count_if(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(place),
                                                    [](char byte) { return (byte & 0xC0) != 0x80; }));
}

}  // namespace

TextError::TextError(int where, const std::string& what_is_wrong, const std::string& what_is_right)
    : std::runtime_error(shown(what_is_wrong + ", expected " + what_is_right)),
      line(where),
      problem(shown(what_is_wrong)),
      expected(shown(what_is_right)) {}

std::string_view content_of_line(std::string_view raw, int number, std::size_t longest) {
  if (number == 1) {
    if (const std::string encoding = wide_encoding(raw); !encoding.empty())
      throw TextError(1, "the file is in " + encoding, "UTF-8 (choose it when the file is saved)");
    if (raw.starts_with(kByteOrderMark)) raw.remove_prefix(kByteOrderMark.size());
  }
  if (raw.size() > longest)
    throw TextError(number, "a line of " + std::to_string(raw.size()) + " bytes", "at most " + std::to_string(longest));
  while (raw.ends_with('\r')) raw.remove_suffix(1);
  if (const std::size_t place = raw.find('\0'); place != std::string_view::npos)
    throw TextError(number, "a byte \\x00 at column " + std::to_string(column_of(raw, place)), "text");
  if (const std::size_t place = raw.find('\r'); place != std::string_view::npos)
    throw TextError(number, "a carriage return (\\x0D) at column " + std::to_string(column_of(raw, place)),
                    "lines that end with LF or CRLF");
  return raw;
}

std::string_view without_dos_end(std::string_view text) noexcept {
  if (text.ends_with(kDosEnd)) text.remove_suffix(1);
  return text;
}

TextLines::TextLines(std::string_view text) : rest_(without_dos_end(text)) {}

bool TextLines::next() {
  if (rest_.empty()) return false;
  const std::size_t size = std::min(rest_.find('\n'), rest_.size());
  const std::string_view raw = rest_.substr(0, size);
  rest_.remove_prefix(std::min(size + 1, rest_.size()));
  line_ = content_of_line(raw, ++number_);
  return true;
}

std::string_view trimmed(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string_view without_comment(std::string_view line, char mark) noexcept {
  for (std::size_t place = line.find(mark); place != std::string_view::npos; place = line.find(mark, place + 1))
    if (place == 0 || kBlanks.find(line[place - 1]) != std::string_view::npos) return line.substr(0, place);
  return line;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t begin = line.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t size = std::min(line.find_first_of(kBlanks), line.size());
    words.push_back(line.substr(0, size));
    line.remove_prefix(size);
  }
}

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t size = std::min(line.find(separator), line.size());
    std::string_view cell = trimmed(line.substr(0, size));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = trimmed(cell.substr(1, cell.size() - 2));
    cells.push_back(cell);
    if (size == line.size()) break;
    line.remove_prefix(size + 1);
  }
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

}  // namespace mrroc::core
