#pragma once

#include <string>
#include <vector>

#include "cli/output/black_boxes.hpp"
#include "cli/output/outputs.hpp"
#include "cli/processes/process_plan.hpp"
#include "cli/run/run_options.hpp"
#include "config/deployment.hpp"
#include "links/transport/domain.hpp"
#include "process/arguments.hpp"

namespace mrroc::cli {

/// What all processes of a run on this machine have in common.
struct Surroundings {
  const config::Deployment& deployment;
  const RunOptions& options;
  const Outputs& outputs;
  const BlackBoxes& black_boxes;
  int domain = 0;
  std::string own_address;         ///< the interface, where the deployment names none but has several hosts
  std::vector<std::string> peers;  ///< the other machines
  int deployment_fd = -1;          ///< its text
  int clock_fd = -1;
  int world_fd = -1;
};

/// The command line of one process of the plan.
process::Arguments arguments_for(const PlannedProcess& process, const Surroundings& surroundings);
/// How the runner itself takes part in the communication.
links::DomainOptions domain_options(const Surroundings& surroundings);

/// Refuses an interface that is missing, down or without an address, and invalid keys, before anything starts. Returns
/// a warning when no keys keep unknown participants out; empty: none. Throws std::runtime_error: the mistake is the
/// user's, nothing has moved.
std::string check_network(const config::NetworkEntry& network);

}  // namespace mrroc::cli
