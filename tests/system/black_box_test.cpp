// The last steps of a killed task, and of the tasks that end because of it, are on disk.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <utility>

#include "cli/trace/trace_steps.hpp"
#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::black_box_test {
namespace {

constexpr int kUsage = 2;
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

TEST_F(BlackBoxOfADeath, FolderThatCannotHoldItIsRefused) {
  const std::filesystem::path file = folder_.write("file", "1\n"), loose = folder_ / "loose", loop = folder_ / "loop";
  std::filesystem::create_symlink("/no/such", loose);
  std::filesystem::create_symlink("loop", loop);
  for (const std::filesystem::path& folder :
       {file, file / "boxes", loose, loop, loop / "boxes", std::filesystem::path{"/dev/null"}}) {
    const std::string refused = run_mrroc({"run", "tasks/press/press.toml", "--black-box", folder.string()}, kUsage);
    EXPECT_NE(refused.find("--black-box " + folder.string() + ": "), std::string::npos) << refused;
    EXPECT_EQ(refused.find("ready"), std::string::npos) << refused;
  }
}

TEST_F(BlackBoxOfADeath, FolderIsMadeWhenItIsNeeded) {
  const std::string deployment = folder_.write("exception.toml", faulty_deployment("exception"));
  const std::filesystem::path deep = folder_ / "new" / "boxes";
  run_mrroc({"run", "--check", deployment, "--black-box", deep.string()}, 0);
  EXPECT_FALSE(std::filesystem::exists(deep.parent_path()));
  run_mrroc({"run", deployment, "--black-box", deep.string()}, kSystem);
  EXPECT_TRUE(std::filesystem::exists(deep / "exception-arm.mcap"));
}

TEST_F(BlackBoxOfADeath, ThatCannotBeWrittenToTheDefaultFolderIsReported) {
  folder_.write("mrroc-black-box", "a file\n");
  const std::string press = MRROC_SOURCE_DIR "/tasks/press/press.toml' --inject 'kill ecp:arm at step 120";
  const std::string exception = folder_.write("exception.toml", faulty_deployment("exception"));
  // written by the runner, and by the task's process
  for (const auto& [run, name] : {std::pair{press, "press-arm"}, std::pair{exception, "exception-arm"}}) {
    const std::string command =
        "cd '" + folder_.path().string() + "' && '" MRROC_BINARY_DIR "/bin/mrroc' run '" + run + "' > out 2>&1";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), kSystem);
    const std::string reported = text_of(folder_ / "out"), file = "mrroc-black-box/" + std::string{name} + ".mcap";
    for (const std::string& part : {"warning: --black-box mrroc-black-box: " + (folder_ / "mrroc-black-box").string(),
                                    "cannot write the black box " + file})
      EXPECT_NE(reported.find(part), std::string::npos) << part << "\n" << reported;
    EXPECT_EQ(reported.find("; black box: "), std::string::npos) << reported;
  }
}

}  // namespace
}  // namespace mrroc::test::black_box_test
