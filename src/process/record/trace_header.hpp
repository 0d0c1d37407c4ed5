#pragma once

#include <string_view>

namespace mrroc::process {

/// The beginning of the first line of a trace; the clock's name follows: "# mrroc trace 2 clock=lockstep".
inline constexpr std::string_view kTraceHeader = "# mrroc trace 2 clock=";

/// Behind it in the first line of a black box: the lines are the last ones of a process, earlier ones are missing.
inline constexpr std::string_view kBlackBoxMark = " black_box";

}  // namespace mrroc::process
