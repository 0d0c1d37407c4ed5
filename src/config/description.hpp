#pragma once

#include <string>

#include "config/deployment.hpp"

namespace mrroc::config {

/// A summary for people, one line for the deployment and one for each process that it starts, with its program:
///
///     press: lockstep, servo period 0.002 s, any free DDS domain
///       mp     /opt/mrroc/bin/mrroc_mp
///       sim    /opt/mrroc/bin/mrroc_sim, scene /cell/press.xml, time step 0.001 s
///       arm    irb6 on mujoco: ECP /cell/press_ecp, EDP /opt/mrroc/bin/irb6_edp
///       wrist  force_torque on arm, interactive, simulated: VSP /opt/mrroc/bin/force_torque_vsp
///
/// Lines end with a newline. The format is not for parsing.
std::string describe(const Deployment& deployment);

}  // namespace mrroc::config
