// The last steps of a killed task, and of the tasks that end because of it, are on disk.
#include <gtest/gtest.h>

#include <algorithm>

#include "system/mrroc_run.hpp"
#include "system/trace_line.hpp"

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
  const std::filesystem::path box = boxes() / "press-arm.trace", whole = folder_.path() / "press.trace";
  const std::string reported = run("tasks/press/press.toml", "kill ecp:arm at step 120");
  EXPECT_NE(reported.find("black box: " + box.string() + "\n"), std::string::npos) << reported;
  expect_laws(box);
  run_mrroc({"run", "tasks/press/press.toml", "--trace", whole.string()}, 0);
  const auto kept = lines_with(box, " process=arm "), all = lines_with(whole, " process=arm ");
  EXPECT_FALSE(std::filesystem::exists(boxes() / "press-mp.trace")) << "that task has no steps";
  ASSERT_EQ(kept.size(), 50U);
  ASSERT_GT(all.size(), 120U);
  EXPECT_EQ(kept, std::vector<std::string>(all.begin() + 70, all.begin() + 120));
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
  EXPECT_NE(reported.find((boxes() / "nested-mp.trace").string()), std::string::npos) << reported;
  for (const std::string process : {"left", "mp"}) {
    const auto box = boxes() / ("nested-" + process + ".trace");
    expect_laws(box);
    EXPECT_FALSE(lines_with(box, " process=" + process + " ").empty()) << reported;
  }
  EXPECT_FALSE(std::filesystem::exists(boxes() / "nested-right.trace")) << "that task has no steps";
}

TEST_F(BlackBoxOfADeath, IsNotWrittenWhenDisabled) {
  const std::string none =
      run_mrroc({"run", "tasks/press/press.toml", "--inject", "kill ecp:arm at step 120", "--black-box", ""}, kSystem);
  EXPECT_EQ(none.find("black box"), std::string::npos) << none;
}

TEST_F(BlackBoxOfADeath, ReportsAWriteError) {
  const auto blocked = folder_.write("boxes", "a file");
  const std::string reported = run("tasks/press/press.toml", "kill ecp:arm at step 120");
  EXPECT_NE(reported.find("cannot write the black box " + (blocked / "press-arm.trace").string()), std::string::npos)
      << reported;
}

}  // namespace
}  // namespace mrroc::test::black_box_test
