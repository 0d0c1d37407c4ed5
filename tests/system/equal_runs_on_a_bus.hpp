#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "system/mrroc_run.hpp"

namespace mrroc::test {

/// Runs a deployment twice in lockstep, one run after the other, because both have the same bus. Expects success, these
/// words in the output, and equal traces. Files are in `folder`.
inline void expect_equal_runs_on_a_bus(const std::filesystem::path& deployment, const ScratchFolder& folder,
                                       const std::vector<std::string>& words) {
  std::string hashes[2];
  for (int i = 0; i < 2; ++i) {
    const auto trace = folder.path() / ("trace" + std::to_string(i) + ".mcap");
    const std::string output =
        run_mrroc({"run", deployment.string(), "--record", trace.string()}, 0, MrrocRun::kLongPatience);
    for (const std::string& word : words) EXPECT_NE(output.find(word), std::string::npos) << output;
    hashes[i] = trace_hash(trace);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace mrroc::test
