#pragma once

#include "mrroc/robot_state.hpp"

namespace mrroc {

/// An error report with a text formatted as by printf, cut to the capacity of a report. Any thread; allocates nothing,
/// never throws.
[[gnu::format(printf, 3, 4)]] ErrorReport make_report(ErrorClass error_class, ErrorCode code, const char* format,
                                                      ...) noexcept;

inline bool bad(const ErrorReport& report) noexcept { return report.error_class != ErrorClass::none; }

}  // namespace mrroc
