#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mrroc::canopen {

/// A mistake in an EDS file: "<file>:<line>: <section>: <key>: <what is wrong>, expected <what>".
class EdsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// `line` 0, `where` empty: left out. Invisible characters are written as by core::shown.
  EdsError(const std::string& file, int line, const std::string& where, const std::string& problem,
           const std::string& expected);
};

/// A line KEY=VALUE.
struct EdsLine {
  std::string key;    ///< in small letters
  std::string value;  ///< without its comment, and without double quotes around it
  int number = 0;     ///< of the line, from 1
};

struct EdsSection {
  std::string name;  ///< in small letters
  std::vector<EdsLine> lines;
  int number = 0;  ///< of its first line

  /// Null when it has no such key.
  const EdsLine* find(std::string_view key) const;
};

/// The sections of an EDS or DCF file in file order (CiA 306-1, 4.2). A line that begins with `;` or `#` is a comment,
/// as is what follows a `;` behind a blank, or behind a section's name or a value in double quotes. For what surrounds
/// a line see core/text_lines.hpp. Throws EdsError: a line that is neither section nor key nor comment, a key before
/// the first section. Configuration time; any thread.
std::vector<EdsSection> read_eds_sections(std::string_view text, const std::string& file);

/// `'text'`.
std::string in_quotes(std::string_view text);

/// ASCII letters in lower case.
std::string small_letters(std::string_view text);

}  // namespace mrroc::canopen
