#include "cli/processes/launch.hpp"

#include <stdexcept>

#include "config/network/network_entry.hpp"
#include "links/transport/network_interface.hpp"
#include "links/transport/security.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::cli {

namespace {

/// Of the addresses of a named device, the one that leads to the hosts: the hosts may have no route to the others.
std::string interface_of(const Surroundings& surroundings) {
  const std::string& named = surroundings.deployment.network.interface;
  const std::string& own = surroundings.own_address;
  if (named.empty() || own.empty()) return named.empty() ? own : named;
  return links::find_interface(named).address == named ? named : own;
}

}  // namespace

process::Arguments arguments_for(const PlannedProcess& process, const Surroundings& surroundings) {
  const RunOptions& options = surroundings.options;
  const config::NetworkEntry& network = surroundings.deployment.network;
  process::Arguments arguments;
  arguments.deployment = surroundings.deployment.file;
  arguments.deployment_fd = surroundings.deployment_fd;
  arguments.name = process.name;
  arguments.clock_fd = surroundings.clock_fd;
  arguments.world_fd = surroundings.world_fd;
  arguments.domain = surroundings.domain;
  arguments.interface = interface_of(surroundings);
  if (network.security) arguments.keys = network.keys;
  arguments.peers = surroundings.peers;
  if (surroundings.recorder != nullptr) arguments.record_fd = surroundings.recorder->fd_of(process.name);
  if (process.has_task) arguments.black_box = options.black_box;
  arguments.black_box_fd = surroundings.black_boxes.fd_of(process.name);
  arguments.picture_fd = surroundings.cameras.fd_of(process.name);
  if (process.name == "mp") arguments.behaviours = options.behaviours;
  if (process.name == "sim") arguments.snapshots = options.snapshots;
  if (process.name == "sim") {
    arguments.motion = options.motion;
    arguments.motion_fd = surroundings.outputs.motion();
  }
  arguments.faults = options.faults;
  return arguments;
}

links::DomainOptions domain_options(const Surroundings& surroundings) {
  const config::Deployment& deployment = surroundings.deployment;
  links::DomainOptions options;
  options.id = surroundings.domain;
  options.interface = interface_of(surroundings);
  if (deployment.network.security) options.keys = deployment.network.keys;
  options.lease = deployment.clock == config::ClockMode::real ? deployment.heartbeat_timeout : 0;
  options.hosts = surroundings.peers;
  return options;
}

std::string check_network(const config::NetworkEntry& network) {
  try {
    links::find_interface(network.interface);
  } catch (const SystemError& error) {
    throw std::runtime_error(error.detail());
  }
  if (!network.security) {
    if (!config::beyond_loopback(network.interface)) return "";
    return "warning: without security anyone who reaches the interface " + network.interface +
           " can command the robots; make keys with `mrroc keys` (docs/how-to/security.md)";
  }
  try {
    links::check_keys(network.keys);
  } catch (const SystemError& error) {
    throw std::runtime_error(error.detail());
  }
  return "";
}

}  // namespace mrroc::cli
