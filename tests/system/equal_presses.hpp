#pragma once

#include <gtest/gtest.h>

#include <string>

#include "system/mrroc_run.hpp"

namespace mrroc::test {

/// Runs press twice, one run after the other, because both have the same bus. Expects its end, at 9.342 s, and equal
/// traces. Files are in `folder`.
inline void expect_equal_presses(const std::filesystem::path& deployment, const ScratchFolder& folder) {
  std::string hashes[2];
  for (int i = 0; i < 2; ++i) {
    const auto trace = folder.path() / ("trace" + std::to_string(i));
    const std::string output = run_mrroc({"run", deployment.string(), "--trace", trace.string()}, 0);
    EXPECT_NE(output.find("press succeeded: 9.342 s"), std::string::npos) << output;
    hashes[i] = trace_hash(trace);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace mrroc::test
