#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

constexpr const char* kDeployment = "tasks/press_replay/press_replay.toml";

TEST(Replay, LoopbackDrivesAndPlayedReadingsNeedNoSimulator) {
  const ScratchFolder folder;
  const auto first = folder.path() / "first";
  const auto second = folder.path() / "second";
  const std::string output = run_mrroc({"run", kDeployment, "--trace", first.string()}, 0);
  EXPECT_EQ(output.find("sim "), std::string::npos) << output;
  run_mrroc({"run", kDeployment, "--quiet", "--trace", second.string()}, 0);
  EXPECT_EQ(trace_hash(first), trace_hash(second));
}

TEST(Replay, TheSameRunsInRealTime) { run_mrroc({"run", kDeployment, "--quiet", "--clock", "real"}, 0); }

}  // namespace
}  // namespace mrroc::test
