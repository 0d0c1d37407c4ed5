#pragma once

#include <string>

#include "cli/trace/line.hpp"
#include "cli/trace/reader.hpp"

namespace mrroc::cli::trace {

/// A line as a process writes it: what `parse_line` reads, to the last bit.
std::string format_line(const Line& line);
std::string format_remark(const Remark& remark);

}  // namespace mrroc::cli::trace
