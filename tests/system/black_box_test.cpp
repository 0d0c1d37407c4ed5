// The last steps of a killed task, and of the tasks that end because of it, are on disk.
#include <gtest/gtest.h>

#include "cli/trace/trace_steps.hpp"
#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::black_box_test {
namespace {

constexpr int kSystem = 4;

class BlackBoxOfADeath : public testing::Test {
 protected:
  /// Runs with a fault that ends a process; returns the output.
  std::string run(const std::string& deployment, const std::string& fault) {
    return run_mrroc({"run", deployment, "--inject", fault, "--black-box", boxes().string()}, kSystem);
  }

  std::filesystem::path boxes() const { return folder_.path() / "boxes"; }

  ScratchFolder folder_;
};

TEST_F(BlackBoxOfADeath, HasTheStepsOfAKilledTaskUpToItsDeath) {
  const std::filesystem::path box = boxes() / "press-arm.mcap", whole = folder_.path() / "press.mcap",
                              part = folder_.path() / "part.mcap";
  const std::string reported = run("tasks/press/press.toml", "kill ecp:arm at step 120");
  EXPECT_NE(reported.find("black box: " + box.string() + "\n"), std::string::npos) << reported;
  expect_laws(box);
  run_mrroc({"run", "tasks/press/press.toml", "--record", whole.string()}, 0);
  EXPECT_FALSE(std::filesystem::exists(boxes() / "press-mp.mcap")) << "that task has no steps";
  const auto all = cli::trace::read_trace(whole);
  ASSERT_EQ(cli::trace::line_count(cli::trace::read_trace(box), "arm"), 50U);
  ASSERT_GT(cli::trace::line_count(all, "arm"), 120U);
  cli::trace::black_box_of(all, "arm", 70, 120).write(part);
  run_mrroc({"trace", "diff", box.string(), part.string()}, 0);
  EXPECT_EQ(trace_hash(box), trace_hash(part));
}

TEST_F(BlackBoxOfADeath, HasTheStepsOfTasksThatEndBecauseOfIt) {
  const std::string belt =
      "type = \"conveyor\"\nhardware = \"loopback\"\nprogram = \"" MRROC_BINARY_DIR "/tests/nested_ecp\"\n";
  const auto deployment =
      folder_.write("nested.toml", "[deployment]\nname = \"nested\"\n[mp]\nprogram = \"" MRROC_BINARY_DIR
                                   "/tests/nested_mp\"\n[robots.left]\n" +
                                       belt + "[robots.right]\n" + belt);
  const std::string reported = run(deployment.string(), "kill edp:right at tick 3800");
  EXPECT_NE(reported.find("process right_edp died: signal 9 (Killed)"), std::string::npos) << reported;
  EXPECT_NE(reported.find((boxes() / "nested-mp.mcap").string()), std::string::npos) << reported;
  for (const std::string process : {"left", "mp"}) {
    const auto box = boxes() / ("nested-" + process + ".mcap");
    expect_laws(box);
    const Steps steps = steps_where(box, [&](const cli::trace::Line& line) { return line.process == process; });
    EXPECT_FALSE(steps.empty()) << reported;
  }
  EXPECT_FALSE(std::filesystem::exists(boxes() / "nested-right.mcap")) << "that task has no steps";
}

TEST_F(BlackBoxOfADeath, IsNotWrittenWhenDisabled) {
  const std::string none =
      run_mrroc({"run", "tasks/press/press.toml", "--inject", "kill ecp:arm at step 120", "--black-box", ""}, kSystem);
  EXPECT_EQ(none.find("black box"), std::string::npos) << none;
}

TEST_F(BlackBoxOfADeath, ReportsAWriteError) {
  const auto blocked = folder_.write("boxes", "a file");
  const std::string reported = run("tasks/press/press.toml", "kill ecp:arm at step 120");
  EXPECT_NE(reported.find("cannot write the black box " + (blocked / "press-arm.mcap").string()), std::string::npos)
      << reported;
}

}  // namespace
}  // namespace mrroc::test::black_box_test
