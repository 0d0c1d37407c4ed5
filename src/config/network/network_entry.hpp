#pragma once

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads the table [network] of the file `root`, after its robots: which interface the processes use, and whether they
/// know each other by keys. Security is on by default as soon as a robot has a `host`, an interface beyond loopback is
/// named, or keys are. Throws ConfigurationError: a host that is another machine without an interface to reach it by,
/// security without keys, a key folder that is not there.
NetworkEntry read_network(const Table& root, const Deployment& deployment);

/// Whether a deployment on `interface` can be reached from other machines: all but the loopback device and its
/// addresses.
bool beyond_loopback(const std::string& interface);

}  // namespace mrroc::config
