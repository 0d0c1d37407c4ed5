#pragma once

#include <string_view>

namespace mrroc::command {

/// Writes text, made printable line by line, to the standard output at once. Throws SystemError(resources) with the
/// system's reason when it cannot be written: a full disk, a file size limit. Main thread; waits for the reader of a
/// pipe.
void print(std::string_view text);

/// Flushes the standard output of std::printf and the like. Throws as print() when any of it could not be written.
void finish_output();

}  // namespace mrroc::command
