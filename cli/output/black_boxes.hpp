#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/processes/process_plan.hpp"
#include "process/record/shared_black_box.hpp"
#include "recording/last_steps.hpp"

namespace mrroc::cli {

/// The black boxes of a run's tasks. A task that fails writes its own. The last steps of the others are in memory of
/// the runner, which writes them when the run has failed as a whole, or on the operator's request. Those of a task on
/// another host are in memory there, and its agent sends them at the end. Main thread.
class BlackBoxes {
 public:
  /// `folder` empty: none is written. `text`: of the deployment. References must outlive it. Throws
  /// SystemError(resources) without memory.
  BlackBoxes(const std::filesystem::path& folder, const config::Deployment& deployment, const std::string& text,
             const std::vector<PlannedProcess>& processes);

  /// Why no file can be made in the folder, which need not exist yet: "/boxes: Permission denied"; empty: one can.
  std::string problem() const;
  /// The descriptor that the process inherits; -1 when it has none, or is on another host.
  int fd_of(const std::string& process) const noexcept;
  /// One of the last steps of a task on another host, the oldest first.
  void take(const std::string& process, recording::RecordedStep step);
  /// The written ones, as text that follows the failure: "; black box: FILE"; empty without one.
  std::string reported() const;
  /// Call it when all processes have ended. Writes the black boxes of the tasks that made a step but have not written
  /// their own. Returns a line for the operator that names the files; empty without one.
  std::string save_rest() const;
  /// Writes the last steps of all tasks on this machine as one black box, while they run. The file must not exist; a
  /// relative path is in the working folder. Returns "100 steps of arm, mp; black box: /PATH". Throws std::logic_error
  /// when there is no step to be written, std::runtime_error when the file exists or cannot be written; then no file
  /// remains.
  std::string record(const std::filesystem::path& path) const;

 private:
  struct Box {
    std::string process;
    std::optional<process::SharedBlackBox> last_steps;  ///< none: it is on another host
    std::vector<recording::RecordedStep> reported;      ///< received from that host
  };
  /// The file that the task itself has written; empty without one.
  std::filesystem::path written(const Box& box) const;
  void write_steps(const std::filesystem::path& path, const recording::LastSteps& steps) const;

  const std::filesystem::path folder_;
  const config::Deployment& deployment_;
  const std::string& text_;
  std::vector<Box> boxes_;
};

}  // namespace mrroc::cli
