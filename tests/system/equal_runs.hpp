#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "system/mrroc_run.hpp"

namespace mrroc::test {

/// What several runs of one deployment have left behind.
struct EqualRuns {
  std::vector<std::string> outputs;  ///< of each
  std::filesystem::path trace;       ///< of the first, as of all
  std::filesystem::path states;      ///< folder of the snapshots that the first has saved
};

/// Runs the deployment three times in lockstep, each for at most `patience` s: two runs side by side, then one alone.
/// Expects that all succeed and that all have the same trace, which keeps the laws and is read to the last bit. The
/// files are in `folder`. With a sanitizer two runs.
EqualRuns expect_equal_runs(const std::string& deployment, const ScratchFolder& folder,
                            int patience = MrrocRun::kPatience);

}  // namespace mrroc::test
