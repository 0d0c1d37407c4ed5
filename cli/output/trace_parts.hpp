#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/output/trace_output.hpp"
#include "cli/processes/process_plan.hpp"
#include "process/record/claimed_file.hpp"

namespace mrroc::cli {

/// The parts of a trace while its run writes them: one file for each process with a task, `<trace>.<process>.part`
/// beside the trace, or in the folder for temporary files when the trace is a stream. The files are always new: where
/// an earlier or killed run has left a file of this name, the name is `<trace>.<process>.2.part`, and so on. Main
/// thread.
class TraceParts {
 public:
  /// Throws std::runtime_error when a file cannot be made.
  TraceParts(const TraceOutput& output, const std::vector<PlannedProcess>& processes);

  /// The open file of a process; -1 when it writes none.
  int fd_of(const std::string& process) const noexcept;
  /// Writes a line of a process on another host.
  void take(const std::string& process, const std::string& line);
  /// Joins the parts to the trace and removes them; after an error they stay. Throws std::runtime_error that names the
  /// trace, the reason and the paths of the parts.
  void join(TraceOutput& output, config::ClockMode clock, const TraceOutput::Continue& go_on);
  /// Removes the files of a run that has not begun.
  void remove();

 private:
  std::map<std::string, process::ClaimedFile> parts_;  // by process
  int failure_ = 0;                                    // errno of the first line of another host that was lost
};

}  // namespace mrroc::cli
