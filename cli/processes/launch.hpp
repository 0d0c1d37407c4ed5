#pragma once

#include <string>
#include <vector>

#include "cli/output/black_boxes.hpp"
#include "cli/output/outputs.hpp"
#include "cli/processes/camera_memories.hpp"
#include "cli/processes/process_plan.hpp"
#include "cli/record/recorder.hpp"
#include "cli/run/run_options.hpp"
#include "config/deployment.hpp"
#include "links/transport/domain.hpp"
#include "process/arguments.hpp"

namespace mrroc::cli {

/// Options that all processes of a run on this machine share.
struct Surroundings {
  const config::Deployment& deployment;
  const RunOptions& options;
  const Outputs& outputs;
  const BlackBoxes& black_boxes;
  const CameraMemories& cameras;
  const record::Recorder* recorder = nullptr;  ///< null: the run is not recorded
  int domain = 0;
  std::string own_address;         ///< the interface, when the deployment names none but has several hosts
  std::vector<std::string> peers;  ///< the other machines
  int deployment_fd = -1;          ///< its text
  int clock_fd = -1;
  int world_fd = -1;
};

/// The command line of one process of the plan.
process::Arguments arguments_for(const PlannedProcess& process, const Surroundings& surroundings);
/// The runner's own options for the communication.
links::DomainOptions domain_options(const Surroundings& surroundings);

/// Rejects an interface that is missing, down or without an address, and invalid keys, before anything starts. Returns
/// a warning when no keys keep unknown participants out; else empty. Throws std::runtime_error for a mistake of the
/// user; nothing has moved.
std::string check_network(const config::NetworkEntry& network);

}  // namespace mrroc::cli
