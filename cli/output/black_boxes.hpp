#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/processes/process_plan.hpp"
#include "process/record/shared_black_box.hpp"

namespace mrroc::cli {

/// The black boxes of a run's tasks. A task that fails writes its own. The last steps of the others are in memory of
/// the runner, which writes them when the run has failed as a whole. Those of a task on another host are in memory
/// there, and its agent sends them at the end. Main thread.
class BlackBoxes {
 public:
  /// `folder` empty: none is written. References must outlive it. Throws SystemError(resources) without memory.
  BlackBoxes(const std::filesystem::path& folder, const config::Deployment& deployment,
             const std::vector<PlannedProcess>& processes);

  /// The descriptor that the process inherits; -1 when it has none, or is on another host.
  int fd_of(const std::string& process) const noexcept;
  /// A line of the last steps of a task on another host, the oldest first.
  void take(const std::string& process, const std::string& line);
  /// The written ones, as text that follows the failure: "; black box: FILE"; empty when there is none.
  std::string reported() const;
  /// Call it when all processes have ended. Writes the black boxes of the tasks that made a step but have not written
  /// their own. Returns a line for the operator that names the files; empty when there is none.
  std::string save_rest() const;

 private:
  struct Box {
    std::string process;
    std::optional<process::SharedBlackBox> last_steps;  ///< none: it is on another host
    std::vector<process::TextLine> reported;            ///< received from that host
  };
  /// The file that the task itself has written; empty when there is none.
  std::filesystem::path written(const Box& box) const;

  const std::filesystem::path folder_;
  const config::Deployment& deployment_;
  std::vector<Box> boxes_;
};

}  // namespace mrroc::cli
