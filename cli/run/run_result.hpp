#pragma once

#include <map>
#include <string>
#include <vector>

#include "links/wire/process_status.hpp"
#include "mrroc/types.hpp"
#include "process/exit_code.hpp"

namespace mrroc::cli {

/// How a run ended.
struct RunResult {
  process::ExitCode code = process::ExitCode::success;
  std::string reason;                                    ///< one line, written to stderr at once; empty on success
  Tick ticks = 0;                                        ///< simulated length
  double wall_seconds = 0;                               ///< from the start of the task to its end
  std::map<std::string, links::ProcessStatus> statuses;  ///< last status of each process
  std::vector<std::string> hosts;                        ///< a line about each other host
};

}  // namespace mrroc::cli
