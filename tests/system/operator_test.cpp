#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>
#include <set>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

constexpr int kStopped = 5;

/// The task press with operator events appended.
std::filesystem::path press_with(const ScratchFolder& folder, const std::string& events) {
  std::ifstream original(std::string{MRROC_SOURCE_DIR} + "/tasks/press/press.toml");
  std::string text{std::istreambuf_iterator<char>(original), {}};
  const std::string scene = "scene = \"press.xml\"";
  text.replace(text.find(scene), scene.size(), "scene = \"" MRROC_SOURCE_DIR "/tasks/press/press.xml\"");
  return folder.write("press.toml", text + events);
}

std::string event(int tick, const std::string& command) {
  return "\n[[events]]\ntick = " + std::to_string(tick) + "\ncommand = \"" + command + "\"\n";
}

std::size_t last_tick(const std::filesystem::path& trace) {
  std::ifstream file(trace);
  std::size_t tick = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("tick=")) tick = std::stoul(line.substr(5));
  }
  return tick;
}

TEST(Operator, APauseHoldsTheRobotAndTheTaskGoesOnAfterwards) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "trace";
  run_mrroc({"run", press_with(folder, "").string(), "--quiet", "--trace", trace.string()}, 0);
  const std::size_t undisturbed = last_tick(trace);
  const auto paused = press_with(folder, event(1500, "pause") + event(2500, "resume"));
  std::set<std::string> hashes;
  for (int i = 0; i < 3; ++i) {
    run_mrroc({"run", paused.string(), "--quiet", "--trace", trace.string()}, 0);
    hashes.insert(trace_hash(trace));
  }
  EXPECT_EQ(hashes.size(), 1U);
  // the motion is planned anew from where the robot has stopped: it takes the pause and some more
  EXPECT_GE(last_tick(trace), undisturbed + 900);
}

TEST(Operator, AStopEndsTheTaskWithItsOwnExitCode) {
  const ScratchFolder folder;
  const std::string output = run_mrroc({"run", press_with(folder, event(1500, "stop")).string()}, kStopped);
  EXPECT_NE(output.find("stopped by the operator"), std::string::npos) << output;
}

TEST(Operator, CtrlCStopsTheTask) {
  MrrocRun run({"run", "tasks/press/press.toml", "--clock", "paced"});
  ASSERT_TRUE(run.wait_for_output("JointLine")) << run.out() << run.err();
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
  EXPECT_NE(run.err().find("stopped by the operator"), std::string::npos) << run.err();
  EXPECT_TRUE(run.children().empty());
}

TEST(Operator, CtrlCTwiceEndsAtOnce) {
  MrrocRun run({"run", "tasks/press/press.toml", "--clock", "paced"});
  ASSERT_TRUE(run.wait_for_output("mp           running")) << run.out() << run.err();
  const pid_t mp = run.child("mp");
  kill(mp, SIGSTOP);  // a task that does not react
  run.signal(SIGINT);
  ASSERT_TRUE(run.wait_for_output("stopping"));
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
}

}  // namespace
}  // namespace mrroc::test
