#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "cli/hosts/agent_protocol.hpp"
#include "cli/hosts/line_channel.hpp"
#include "cli/processes/process_plan.hpp"
#include "process/arguments.hpp"
#include "process/record/shared_black_box.hpp"
#include "process/record/step_ring.hpp"

namespace mrroc::cli {

/// Records of the tasks on an agent's host for the runner, as far as its order requests them: their steps for the
/// recording, and their last steps, in memory that outlives the tasks. Main thread.
class TaskRecords {
 public:
  /// Throws SystemError(resources) without memory.
  TaskRecords(const AgentOrder& order, const std::vector<PlannedProcess>& processes);

  /// Adds the descriptors for the records of the process; none for a process without a task.
  void add_to(process::Arguments& arguments) const;
  /// Sends the steps that have been made since the last call, while the runner has not taken fewer than `most` bytes.
  void send_steps(LineChannel& runner, std::size_t most);
  /// Sends all that remains once the processes have ended.
  void send_rest(LineChannel& runner);

 private:
  std::map<std::string, process::StepRing> steps_;             // by process
  std::map<std::string, process::SharedBlackBox> last_steps_;  // by process
};

}  // namespace mrroc::cli
