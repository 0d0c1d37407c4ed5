#pragma once

#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "config/table.hpp"

/// The machines of a deployment: docs/how-to/two-hosts.md.
namespace mrroc::config {

/// Reads every [hosts.NAME], in file order. Throws ConfigurationError.
std::vector<HostEntry> read_hosts(const Table& root);

/// The host that `key` of a robot, sensor or [sim] names: one of `deployment.hosts`, or "" for the runner's machine,
/// which may be called by any of its own names. Throws ConfigurationError. Asks the resolver for a name that is none of
/// the hosts.
std::string read_host(const Table& table, const Deployment& deployment);

/// Checks what robots, sensors and simulator on several machines need of each other, when all are read: one machine for
/// the simulated world and all that reads its memory, and the real clock. Settles where the simulator and the sensors
/// are, and finds their programs where that is here. Throws ConfigurationError.
void settle_places(const Table& root, Deployment& deployment);

}  // namespace mrroc::config
