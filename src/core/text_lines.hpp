#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Lines of the text files that people make: taught paths, readings, EDS files, TOML, letters. Each format
/// defines the content of a line; the rules for what surrounds it are common:
///
/// - a byte order mark of UTF-8 at the beginning of the file is not part of it;
/// - a line ends with LF or CRLF, also mixed, or with the file; a CR elsewhere is an error;
/// - a DOS end-of-file mark (1Ah) as the last byte is not part of it;
/// - UTF-16, UTF-32 and bytes 0 are errors, and lines longer than `kLongestLine`.
///
/// Configuration time; any thread.
namespace mrroc::core {

/// An error in the text of a file. `what()` is "<problem>, expected <expected>"; the reader of the format adds the name
/// of the file.
class TextError : public std::runtime_error {
 public:
  TextError(int line, const std::string& problem, const std::string& expected);
  int line;              ///< from 1
  std::string problem;   ///< as `shown` writes it
  std::string expected;  ///< the same
};

/// Maximum length of a line, bytes.
constexpr std::size_t kLongestLine = 10000;

/// The content of line `number` (from 1) of a file: `raw`, the bytes up to LF, without what surrounds it. Throws
/// TextError.
std::string_view content_of_line(std::string_view raw, int number, std::size_t longest = kLongestLine);

/// The text without the byte 1Ah with which old editors end a file.
std::string_view without_dos_end(std::string_view text) noexcept;

/// Iterates over the lines of a text, which must outlive the iteration.
class TextLines {
 public:
  explicit TextLines(std::string_view text);
  /// Moves to the next line; false at the end. Throws TextError.
  bool next();
  /// Its content, blanks included.
  std::string_view line() const noexcept { return line_; }
  /// Its number, from 1; 0 before the first.
  int number() const noexcept { return number_; }

 private:
  std::string_view rest_;
  std::string_view line_;
  int number_ = 0;
};

/// Without the spaces and tabs around.
std::string_view trimmed(std::string_view text) noexcept;
/// Without a comment: it begins with `mark` at the beginning of the line or behind a space or tab, and ends with the
/// line.
std::string_view without_comment(std::string_view line, char mark) noexcept;
/// Pieces between spaces and tabs.
std::vector<std::string_view> words_of(std::string_view line);
/// Pieces between separators, trimmed, without surrounding double quotes. Empty ones at the end of the line, which
/// spreadsheets write to fill up a table, are omitted.
std::vector<std::string_view> cells_of(std::string_view line, char separator);

}  // namespace mrroc::core
