#pragma once

#include "process/process.hpp"
#include "sim/ur/controller_servers.hpp"

namespace mrroc::sim::ur {

/// A process of a deployment: the simulated controller of one robot, whose joints are those of the simulated world. The
/// robot's EDP reaches it by its ports alone. Returns by an exception, as processes do: Stopped at the end of the
/// deployment, when the arm has no client or no power; SystemError(configuration) for a servo period shorter than the
/// controller's in real time; SystemError(process_silent) for an EDP that sends no set-points in lockstep.
///
/// In lockstep, and paced, the controller's period is that of the servo. Its part is `clock::Part::world`, but it acts
/// beside the EDPs: in each tick it sends the packages and waits for the set-points with `options.lockstep_register`.
[[noreturn]] void serve_world_controller(process::Process& process, const RobotParameters& robot, std::size_t slot,
                                         ControllerServers::Options options);

}  // namespace mrroc::sim::ur
