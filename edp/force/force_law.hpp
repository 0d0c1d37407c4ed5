#pragma once

#include "mrroc/force_law.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::edp {

/// Every value is finite, inertias and dampings are not below 0, a contact axis can move. Class `none`, or a non-fatal
/// error that names the axis. Allocates nothing, never throws.
ErrorReport check_force_law(const ForceLaw& law, const Twist& velocity) noexcept;

/// One period of `law`: the tool's twist delta / dt, in tool axes, from that of the period before and the wrench that
/// the environment exerts on the tool. `dt` above 0, s. Allocates nothing, never throws.
Twist follow_force(const ForceLaw& law, const Twist& velocity, const Wrench& measured, const Twist& previous,
                   double dt) noexcept;

/// The same wrench for a frame that is at `frame` in the present one: its axes, about its origin.
Wrench seen_from(const Pose& frame, const Wrench& wrench) noexcept;

}  // namespace mrroc::edp
