#pragma once

#include "mrroc/load.hpp"
#include "mrroc/robot_model.hpp"

namespace mrroc::kinematics {

/// The same robots with a load on the flange: what their drives can accelerate shrinks. The acceleration limit a of an
/// axis becomes, never above a,
///   (T - m g r) / (I + m r^2)   with a `torque_max` T: what is left of it when it bears the load
///   a I / (I + m r^2)           without: the torque that the stretched arm takes without the load is enough with it
/// and the jerk limit shrinks in the same ratio. I is the axis' greatest inertia (`AxisParameters::inertia_max`), m the
/// load's mass, g = 9.81 m/s^2, r the largest distance that the load's centre (m, in the flange's frame) has from the
/// axis within the limits, from 2000 postures; a sliding axis has r = 1. The robot's own weight is not part of it,
/// velocities stay. Without a mass the robots are returned as they are. Throws SystemError(configuration): an axis
/// cannot bear the load. Configuration time only.
RobotModels with_load(RobotModels models, const Load& load);

}  // namespace mrroc::kinematics
