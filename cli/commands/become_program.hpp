#pragma once

#include <string>
#include <vector>

namespace mrroc::cli {

/// Replaces this process by `program`, a path, with these arguments behind its name: no process waits for it. Throws
/// std::runtime_error when that is not possible. Main thread.
[[noreturn]] void become_program(const std::string& program, std::vector<std::string> arguments);

}  // namespace mrroc::cli
