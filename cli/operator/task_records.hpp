#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/hosts/agent_protocol.hpp"
#include "cli/hosts/line_channel.hpp"
#include "cli/processes/process_plan.hpp"
#include "process/arguments.hpp"
#include "process/record/claimed_file.hpp"
#include "process/record/shared_black_box.hpp"

namespace mrroc::cli {

/// Records of the tasks on an agent's host for the runner, as far as its order requests them: their traces, kept in a
/// folder that this object removes, and their last steps, in memory that outlives the tasks. Main thread.
class TaskRecords {
 public:
  /// Throws std::runtime_error: no folder; SystemError(resources): no memory.
  TaskRecords(const AgentOrder& order, const std::vector<PlannedProcess>& processes);
  ~TaskRecords();
  TaskRecords(const TaskRecords&) = delete;
  TaskRecords& operator=(const TaskRecords&) = delete;

  /// Adds the descriptors for the records of the process; none for a process without a task.
  void add_to(process::Arguments& arguments) const;
  /// Sends all records to the runner once the processes have ended.
  void send(LineChannel& runner) const;

 private:
  std::filesystem::path folder_;                        // of the traces; empty: none
  std::map<std::string, process::ClaimedFile> traces_;  // by process
  std::vector<std::string> tasks_;
  std::map<std::string, process::SharedBlackBox> last_steps_;  // by process
};

}  // namespace mrroc::cli
