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
/// which may be given by any of its own names. Throws ConfigurationError. Asks the resolver for a name that is not one
/// of the hosts.
std::string read_host(const Table& table, const Deployment& deployment);

/// Checks the dependencies of robots, sensors and simulator on several machines, when all are read: one machine for the
/// simulated world and everything that reads its memory, and the real clock. Determines the hosts of the simulator and
/// the sensors, and finds their programs on this host. Throws ConfigurationError.
void settle_places(const Table& root, Deployment& deployment);

}  // namespace mrroc::config
