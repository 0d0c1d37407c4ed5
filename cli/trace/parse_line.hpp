#pragma once

#include "cli/trace/fields.hpp"
#include "cli/trace/line.hpp"

namespace mrroc::cli::trace {

/// Reads one line of a trace, without its end of line and not a remark. Throws Malformed. A line of `longest`
/// characters was cut when it was written: it is read up to `step`, and `cut` is set.
Line parse_line(std::string_view text, std::size_t longest);

}  // namespace mrroc::cli::trace
