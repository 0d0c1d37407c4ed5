#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "clock/clock.hpp"
#include "config/deployment.hpp"

namespace mrroc::cli {

/// One process that a deployment needs.
struct PlannedProcess {
  std::string name;  ///< mp; a robot's name (its ECP); <robot>_edp; <robot>_drives; a sensor's name (its VSP); sim
  std::filesystem::path program;
  clock::Part part = clock::Part::task;
  bool has_task = false;  ///< an MP or ECP: it runs instructions, whose steps may be recorded
  std::string host = {};  ///< where it runs; empty: the runner's machine
};

/// All processes of a deployment: sim and simulated drives first (hardware is there before its drivers), then EDPs,
/// VSPs, ECPs, the MP.
std::vector<PlannedProcess> plan_processes(const config::Deployment& deployment);

std::vector<std::string> names_of(const std::vector<PlannedProcess>& processes);

}  // namespace mrroc::cli
