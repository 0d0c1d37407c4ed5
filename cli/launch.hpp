#pragma once

#include <string>
#include <vector>

#include "cli/black_boxes.hpp"
#include "cli/process_plan.hpp"
#include "cli/run_options.hpp"
#include "cli/trace_parts.hpp"
#include "config/deployment.hpp"
#include "links/domain.hpp"
#include "process/arguments.hpp"

namespace mrroc::cli {

/// What all processes of a run on this machine have in common.
struct Surroundings {
  const config::Deployment& deployment;
  const RunOptions& options;
  const TraceParts& trace;
  const BlackBoxes& black_boxes;
  int domain = 0;
  std::string own_address;         ///< the interface, where the deployment names none but has several hosts
  std::vector<std::string> peers;  ///< the other machines
  int clock_fd = -1;
  int world_fd = -1;
};

/// The command line of one process of the plan.
process::Arguments arguments_for(const PlannedProcess& process, const Surroundings& surroundings);
/// How the runner itself takes part in the communication.
links::DomainOptions domain_options(const Surroundings& surroundings);

/// Keys that are none are told before anything is started; that nobody keeps strangers out, too: on stderr. Throws
/// std::runtime_error: the mistake is the user's, nothing has moved.
void check_network(const config::NetworkEntry& network);

}  // namespace mrroc::cli
