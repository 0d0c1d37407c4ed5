#pragma once

#include "process/process.hpp"
#include "sim/ur/controller_servers.hpp"

namespace mrroc::sim::ur {

/// A process of a deployment: the simulated controller of one robot, whose joints are those of the simulated world. The
/// robot's EDP reaches it by its ports alone. Returns by an exception, as processes do: Stopped at the end of the
/// deployment, when the arm has no client or no power; SystemError(configuration) for a servo period shorter than the
/// controller's, or a clock that is not real.
[[noreturn]] void serve_world_controller(process::Process& process, const RobotParameters& robot, std::size_t slot,
                                         const ControllerServers::Options& options);

}  // namespace mrroc::sim::ur
