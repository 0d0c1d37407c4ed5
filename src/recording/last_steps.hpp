#pragma once

#include <map>
#include <string>
#include <vector>

#include "config/deployment.hpp"
#include "recording/recorded_step.hpp"

namespace mrroc::recording {

/// The last steps of processes, by name, each the oldest first.
using LastSteps = std::map<std::string, std::vector<RecordedStep>>;

/// Writes them to an empty file as a recording that begins in the middle of a run (metadata `black_box`), in the order
/// of their ticks, then of the processes. `simulated`: whether the clock of the processes is. `text`: of the
/// deployment. Returns the errno of the first failed write; 0: the file is complete.
int write_last_steps(int fd, const LastSteps& steps, const config::Deployment& deployment, bool simulated,
                     const std::string& text);

}  // namespace mrroc::recording
