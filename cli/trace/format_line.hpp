#pragma once

#include <string>

#include "cli/trace/line.hpp"
#include "cli/trace/reader.hpp"

namespace mrroc::cli::trace {

/// The line that a process writes for the values that `parse_line` reads, to the last bit.
std::string format_line(const Line& line);
std::string format_remark(const Remark& remark);

}  // namespace mrroc::cli::trace
