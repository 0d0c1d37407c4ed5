#pragma once

#include <cstddef>

#include "process/process.hpp"
#include "sim/netft/netft_server.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

/// The load of the simulated world's sensor `slot`: the negative of the support forces that MuJoCo measures. Zero
/// before the first measurement. `world` outlives it.
NetftLoad load_of_world(const world::WorldMemory& world, std::size_t slot);

/// Index of the sensor for which the process `name` stands in, as "<sensor>_netft". Throws SystemError(simulator)
/// when the deployment has none.
std::size_t sensor_of_process(const config::Deployment& deployment, const std::string& name);

/// The simulated Net F/T of one sensor of a deployment, until the deployment has ended. Under simulated time its time
/// is that of the world, and it answers each request with the present tick's load. Throws Stopped.
void serve_netft(process::Process& process, NetftSettings settings);

}  // namespace mrroc::sim
