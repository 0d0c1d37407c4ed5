#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test::replay_test {
namespace {

constexpr const char* kDeployment = "tasks/press_replay/press_replay.toml";

TEST(Replay, LoopbackDrivesAndReplayedReadingsNeedNoSimulator) {
  const ScratchFolder folder;
  const auto first = folder.path() / "first";
  const auto second = folder.path() / "second";
  const std::string output = run_mrroc({"run", kDeployment, "--trace", first.string()}, 0);
  EXPECT_EQ(output.find("sim "), std::string::npos) << output;
  run_mrroc({"run", kDeployment, "--quiet", "--trace", second.string()}, 0);
  EXPECT_EQ(trace_hash(first), trace_hash(second));
  const std::string text = text_of(first);
  EXPECT_NE(text.find("condition=\"wrist force above 10 N\":1"), std::string::npos) << "no contact was replayed";
}

TEST(Replay, RunsAlsoInRealTime) { run_mrroc({"run", kDeployment, "--quiet", "--clock", "real"}, 0); }

}  // namespace
}  // namespace mrroc::test::replay_test
