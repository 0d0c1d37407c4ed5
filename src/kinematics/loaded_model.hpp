#pragma once

#include "mrroc/load.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::kinematics {

/// The same robots with a load on the flange: what its drives can accelerate shrinks. Acceleration and jerk limits of
/// axis i are multiplied by
///   I_i / (I_i + m r_i^2)
/// with I_i the axis' greatest inertia (`AxisParameters::inertia_max`), m the load's mass and r_i the largest distance
/// that the load's centre (m, in the flange's frame) has from the axis within the limits, from 2000 postures: the
/// torque that the arm stretched out takes without the load is enough with it. A sliding axis has r = 1. Weight and
/// velocities are not part of it. Without a mass the robots are returned as they are. Configuration time only.
RobotModels with_load(RobotModels models, const Load& load);

}  // namespace mrroc::kinematics
