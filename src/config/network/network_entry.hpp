#pragma once

#include "config/deployment.hpp"
#include "config/table.hpp"

namespace mrroc::config {

/// Reads the table [network] of the file `root`, after its robots: which interface the processes use, and whether they
/// authenticate each other by keys. Security is on by default as soon as a robot has a `host`, or an interface beyond
/// loopback or keys are named. Throws ConfigurationError: a host that is another machine without an interface to reach
/// it, security without keys, a missing key folder.
NetworkEntry read_network(const Table& root, const Deployment& deployment);

/// The key `interface` of a table: a network device or an address. Throws ConfigurationError for what is neither.
std::string read_interface(const Table& table);

/// Whether a deployment on `interface` can be reached from other machines: all but the loopback device and its
/// addresses.
bool beyond_loopback(const std::string& interface);

}  // namespace mrroc::config
