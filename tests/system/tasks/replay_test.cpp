#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::replay_test {
namespace {

constexpr const char* kDeployment = "tasks/press_replay/press_replay.toml";

TEST(Replay, LoopbackDrivesAndReplayedReadingsNeedNoSimulator) {
  const ScratchFolder folder;
  const auto first = folder.path() / "first.mcap";
  const auto second = folder.path() / "second.mcap";
  const std::string output = run_mrroc({"run", kDeployment, "--record", first.string()}, 0);
  EXPECT_EQ(output.find("sim "), std::string::npos) << output;
  run_mrroc({"run", kDeployment, "--quiet", "--record", second.string()}, 0);
  EXPECT_EQ(trace_hash(first), trace_hash(second));
  const auto in_contact = [](const cli::trace::Line& step) {
    const cli::trace::ConditionEntry* const force = condition_in(step, "wrist force above 10 N");
    return force != nullptr && force->value;
  };
  EXPECT_FALSE(steps_where(first, in_contact).empty()) << "no contact was replayed";
}

TEST(Replay, RunsAlsoInRealTime) { run_mrroc({"run", kDeployment, "--quiet", "--clock", "real"}, 0); }

}  // namespace
}  // namespace mrroc::test::replay_test
