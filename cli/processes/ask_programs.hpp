#pragma once

#include "config/deployment.hpp"
#include "config/entries/program_behaviours.hpp"

namespace mrroc::cli {

/// Queries the ECP program of every robot for its behaviours. Throws ConfigurationError that names the robot whose
/// program does not report them. Starts processes. Main thread.
config::ProgramsByRobot ask_programs(const config::Deployment& deployment);

}  // namespace mrroc::cli
