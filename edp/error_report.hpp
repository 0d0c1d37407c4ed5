#pragma once

#include "edp/snapshot.hpp"
#include "mrroc/robot_parameters.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::edp {

/// An error report with a text in printf's manner, cut to what a report holds. Allocates nothing, never throws.
[[gnu::format(printf, 3, 4)]] ErrorReport make_report(ErrorClass error_class, ErrorCode code, const char* format,
                                                      ...) noexcept;

inline bool bad(const ErrorReport& report) noexcept { return report.error_class != ErrorClass::none; }

/// A latched fault as the hardware error that the replies carry.
ErrorReport make_report(const Fault& fault, const RobotParameters& parameters) noexcept;

}  // namespace mrroc::edp
