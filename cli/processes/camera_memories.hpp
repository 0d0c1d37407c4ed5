#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/processes/process_plan.hpp"
#include "config/deployment.hpp"
#include "process/picture_memory.hpp"

namespace mrroc::cli {

/// Memories for the pictures of a run's hardware cameras on this machine: their processes store the picture of each
/// reading, the programs beside the run read it. Main thread.
class CameraMemories {
 public:
  /// Throws SystemError(resources) without memory.
  CameraMemories(const config::Deployment& deployment, const std::vector<PlannedProcess>& processes);

  /// The descriptor that the camera's process inherits; -1 when it has none.
  int fd_of(const std::string& process) const noexcept;
  /// The files by which programs of the same user open the memories, by the cameras' names.
  std::map<std::string, std::string> files() const;

 private:
  std::map<std::string, process::PictureMemory> memories_;  // by the names of sensors, which are those of processes
};

}  // namespace mrroc::cli
