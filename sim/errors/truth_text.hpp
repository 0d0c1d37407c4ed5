#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "config/deployment.hpp"

namespace mrroc::sim {

/// The errors that `[sim.errors]` has drawn for the devices of this world, as TOML, with which results of calibrations
/// are compared:
///
///   [robots.NAME]         base_position (m), base_rotation (rad, rpy): true base = nominal * error
///   [robots.NAME.links]   NAME = { position, rotation } of the same kind
///   [robots.NAME.joints]  NAME = { offset, gear, amplitude, phase, backlash, friction }: sim::TrueJoint
///   [sensors.NAME]        of force_torque: bias, drift; of camera: position, rotation, focal, k1
///
/// `deployment` has errors. Throws config::ConfigurationError. Any thread; allocates.
std::string truth_text(const config::Deployment& deployment, const mjModel& model);

}  // namespace mrroc::sim
