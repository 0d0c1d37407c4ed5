#pragma once

#include <string>
#include <string_view>

namespace mrroc::cli {

/// The line that the operator types at a terminal without its own line editing. Space on an empty line is a key: it
/// ends the line at once. Backspace, Ctrl-U (whole line), Ctrl-W (a word), Tab (completes a verb) and the up arrow
/// (the last line again) edit; other control keys do nothing. One thread.
class LineEditor {
 public:
  static constexpr std::size_t kMaxLine = 512;  ///< bytes; more are not taken

  /// Takes typed bytes and returns the lines that they end, each with '\n'; " \n" for the space key.
  std::string feed(std::string_view bytes);
  /// The line as far as it has been typed.
  const std::string& text() const noexcept { return text_; }

 private:
  enum class Escape { none, begun, sequence };

  void take(char byte, std::string& lines);
  void erase_character();
  void erase_word();
  void complete();

  std::string text_, last_;
  Escape escape_ = Escape::none;
};

}  // namespace mrroc::cli
