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

/// What the tasks of an agent's host leave for the runner, as far as its order asks for it: their traces, meanwhile in
/// a folder that goes with this object, and their last steps, in memory that outlives them. Main thread.
class TaskRecords {
 public:
  /// Throws std::runtime_error: no folder; SystemError(resources): no memory.
  TaskRecords(const AgentOrder& order, const std::vector<PlannedProcess>& processes);
  ~TaskRecords();
  TaskRecords(const TaskRecords&) = delete;
  TaskRecords& operator=(const TaskRecords&) = delete;

  /// Adds where the process is to keep its own; none for one without a task.
  void add_to(process::Arguments& arguments) const;
  /// Hands all on, when the processes have ended.
  void send(LineChannel& runner) const;

 private:
  std::filesystem::path folder_;                        // of the traces; empty: none
  std::map<std::string, process::ClaimedFile> traces_;  // by process
  std::vector<std::string> tasks_;
  std::map<std::string, process::SharedBlackBox> last_steps_;  // by process
};

}  // namespace mrroc::cli
