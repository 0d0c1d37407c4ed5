#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/process_plan.hpp"

namespace mrroc::cli {

/// The files that the tasks of a run write when they fail. Those of an earlier run may lie in their places: a file is
/// this run's when it has been written since this object was made. Main thread.
class BlackBoxes {
 public:
  /// `folder` empty: none is written.
  BlackBoxes(const std::filesystem::path& folder, const config::Deployment& deployment,
             const std::vector<PlannedProcess>& processes);

  /// Those that have been written, as words that follow what failed: "; black box: FILE"; empty when there is none.
  std::string told() const;

 private:
  std::map<std::filesystem::path, std::filesystem::file_time_type> files_;  ///< and when they were written before
};

}  // namespace mrroc::cli
