#pragma once

#include <string>
#include <string_view>

namespace mrroc::command {

/// `text` as one line without effects on a terminal: every byte of a control character (C0 but the tab, DEL, C1), of a
/// character that changes the direction of writing or ends a line, and of what is not UTF-8 becomes `\xNN`. For text
/// that comes from files, arguments, messages and other processes. Any thread.
std::string printable(std::string_view text);

/// The same for text of several lines: the ends of the lines stay.
std::string printable_lines(std::string_view text);

}  // namespace mrroc::command
