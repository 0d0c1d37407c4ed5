#pragma once

#include <filesystem>
#include <string>

#include "cli/process_plan.hpp"

namespace mrroc::cli {

/// The trace of a run while it is written: each process with a task writes a part of it, a file beside it.
class TraceParts {
 public:
  /// `trace` empty: none is written. Removes the parts that an earlier run left there when it was killed. Throws
  /// std::runtime_error when it cannot be.
  TraceParts(std::filesystem::path trace, const std::vector<PlannedProcess>& processes);

  /// Where a process writes its part; empty when it writes none.
  std::filesystem::path of(const PlannedProcess& process) const;
  /// Joins the parts to the trace and removes them. Throws std::runtime_error as merge_traces().
  void join(const std::vector<PlannedProcess>& processes, config::ClockMode clock) const;

 private:
  std::filesystem::path trace_;
};

}  // namespace mrroc::cli
