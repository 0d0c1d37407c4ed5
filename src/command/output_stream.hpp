#pragma once

#include <cstdio>

namespace mrroc::command {

/// A stream for writing on a copy of the descriptor `fd`, which stays open; the copy is above 2 and closes on exec.
/// Null, with errno, when the system refuses. The caller closes it and checks the result of fclose.
std::FILE* output_stream(int fd) noexcept;

}  // namespace mrroc::command
