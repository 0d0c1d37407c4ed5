#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/processes/process_plan.hpp"
#include "process/record/shared_black_box.hpp"

namespace mrroc::cli {

/// The black boxes of a run's tasks. A task that fails writes its own; of the others the last steps are in memory of
/// the runner's, which writes them when the run has failed for everybody. Those of a task on another host lie there,
/// and its agent reports them at the end. Main thread.
class BlackBoxes {
 public:
  /// `folder` empty: none is written. References must outlive it. Throws SystemError(resources): there is no memory.
  BlackBoxes(const std::filesystem::path& folder, const config::Deployment& deployment,
             const std::vector<PlannedProcess>& processes);

  /// The descriptor that the process is to inherit; -1: it has none, or is on another host.
  int fd_of(const std::string& process) const noexcept;
  /// A line of the last steps of a task on another host, the oldest first.
  void take(const std::string& process, const std::string& line);
  /// Those that have been written, as words that follow what failed: "; black box: FILE"; empty when there is none.
  std::string told() const;
  /// When all have ended: writes those of the tasks that have not written their own, but made a step. Gives a line for
  /// the operator that names the files; empty when there is none.
  std::string save_rest() const;

 private:
  struct Box {
    std::string process;
    std::optional<process::SharedBlackBox> last_steps;  ///< none: it is on another host
    std::vector<process::TextLine> told;                ///< by that one
  };
  /// The file that the task has written itself; empty: none.
  std::filesystem::path written(const Box& box) const;

  const std::filesystem::path folder_;
  const config::Deployment& deployment_;
  std::vector<Box> boxes_;
};

}  // namespace mrroc::cli
