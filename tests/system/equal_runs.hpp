#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "system/mrroc_run.hpp"

namespace mrroc::test {

/// Results of several runs of one deployment.
struct EqualRuns {
  std::vector<std::string> outputs;  ///< of each
  std::filesystem::path trace;       ///< of the first; the others are equal
  std::filesystem::path states;      ///< folder of the first run's snapshots
};

/// Runs the deployment several times in lockstep (3; thorough: 10), two at a time, each for at most `timeout` s.
/// Expects that all succeed and have the same trace, which keeps the rules and is read to the last bit. The files are
/// in `folder`.
EqualRuns expect_equal_runs(const std::string& deployment, const ScratchFolder& folder,
                            int timeout = MrrocRun::kPatience);

}  // namespace mrroc::test
