#pragma once

#include "core/error_report.hpp"
#include "edp/servo/snapshot.hpp"
#include "mrroc/robot_parameters.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::edp {

using mrroc::bad;
using mrroc::make_report;

/// A latched fault as the hardware error that the replies carry.
ErrorReport make_report(const Fault& fault, const RobotParameters& parameters) noexcept;

}  // namespace mrroc::edp
