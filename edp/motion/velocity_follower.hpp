#pragma once

#include "geometry/desired_state.hpp"
#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

/// The state of the joints `dt` s after `from` when each changes to its velocity in `velocity` in the shortest time
/// under its acceleration and jerk limits (an `AxisStop` in a frame that moves with that velocity). Made for velocities
/// that change at every tick. Allocates nothing, never throws.
DesiredState follow_velocity(const RobotParameters& parameters, const DesiredState& from, const JointVector& velocity,
                             double dt) noexcept;

}  // namespace mrroc::edp
