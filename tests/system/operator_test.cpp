#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <set>
#include <thread>
#include <tuple>

#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::operator_test {
namespace {

constexpr int kStopped = 5;

/// The task press with operator events appended.
std::filesystem::path press_with(const ScratchFolder& folder, const std::string& events) {
  std::string text = text_of(std::string{MRROC_SOURCE_DIR} + "/tasks/press/press.toml");
  const std::string scene = "scene = \"press.xml\"";
  text.replace(text.find(scene), scene.size(), "scene = \"" MRROC_SOURCE_DIR "/tasks/press/press.xml\"");
  return folder.write("press.toml", text + events);
}

std::string event(int tick, const std::string& command) {
  return "\n[[events]]\ntick = " + std::to_string(tick) + "\ncommand = \"" + command + "\"\n";
}

/// Data of the arm from the recording: the tick of a step and the measured joints.
struct Step {
  std::size_t tick = 0;
  std::vector<double> joints;
};

std::vector<Step> read_trace(const std::filesystem::path& trace) {
  std::vector<Step> steps;
  for (const cli::trace::Line& line : steps_of(trace))
    if (!line.robots.empty()) steps.push_back({line.tick, line.robots.front().joints});
  return steps;
}

TEST(Operator, PauseHoldsTheRobotAndTheTaskContinuesAfterwards) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "trace.mcap";
  run_mrroc({"run", press_with(folder, "").string(), "--quiet", "--record", trace.string()}, 0);
  const std::size_t undisturbed = read_trace(trace).back().tick;
  const std::size_t pause = 1500;
  const std::size_t resume = 2500;
  const auto paused = press_with(folder, event(1500, "pause") + event(2500, "resume"));
  std::set<std::string> hashes;
  for (int i = 0; i < 3; ++i) {
    run_mrroc({"run", paused.string(), "--quiet", "--record", trace.string()}, 0);
    hashes.insert(trace_hash(trace));
  }
  EXPECT_EQ(hashes.size(), 1U);
  // the motion is planned again from the position of the stop: it takes the pause and some more
  const std::vector<Step> steps = read_trace(trace);
  EXPECT_GE(steps.back().tick, undisturbed + (resume - pause) * 9 / 10);
  const auto after = std::find_if(steps.begin(), steps.end(), [](const Step& step) { return step.tick > resume; });
  ASSERT_TRUE(after != steps.begin() && after != steps.end());
  const Step& before = *std::prev(after);
  EXPECT_LT(before.tick, pause + 20) << "a step of the instruction while paused";
  // it moves only while it brakes from at most 0.4 rad/s with 1 rad/s^2
  for (std::size_t i = 0; i < before.joints.size(); ++i) EXPECT_NEAR(before.joints[i], after->joints[i], 0.1) << i;
}

TEST(Operator, TriggerEndsTheWaitOfTheTask) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "trace.mcap";
  const auto file = folder.write("trigger.toml", faulty_deployment("trigger") + event(700, "trigger"));
  run_mrroc({"run", file.string(), "--quiet", "--record", trace.string()}, 0);
  const std::size_t end = read_trace(trace).back().tick;
  EXPECT_GE(end, 700U);
  EXPECT_LE(end, 720U);
}

TEST(Operator, StopEndsTheTaskWithItsOwnExitCode) {
  const ScratchFolder folder;
  const auto stopped = press_with(folder, event(1500, "stop"));
  const auto trace = folder.path() / "trace.mcap";
  std::set<std::string> hashes;
  for (int i = 0; i < 3; ++i) {
    const std::string output = run_mrroc({"run", stopped.string(), "--record", trace.string()}, kStopped);
    EXPECT_NE(output.find("stopped by the operator"), std::string::npos) << output;
    hashes.insert(trace_hash(trace));
  }
  EXPECT_EQ(hashes.size(), 1U);
  EXPECT_LE(read_trace(trace).back().tick, 1520U);
}

TEST(Operator, AStopEndsAPause) {
  const ScratchFolder folder;
  run_mrroc({"run", press_with(folder, event(1500, "pause") + event(2000, "stop")).string(), "--quiet"}, kStopped);
}

TEST(Operator, AStopReachesATaskOfTheMp) {
  std::string text = text_of(std::string{MRROC_SOURCE_DIR} + "/tasks/press_mp/press_mp.toml");
  const std::string scene = "../press/press.xml";
  text.replace(text.find(scene), scene.size(), MRROC_SOURCE_DIR "/tasks/press/press.xml");
  const ScratchFolder folder;
  const auto trace = folder.path() / "trace.mcap";
  const auto file = folder.write("press_mp.toml", text + event(1500, "stop"));
  run_mrroc({"run", file.string(), "--quiet", "--record", trace.string()}, kStopped);
  EXPECT_LE(read_trace(trace).back().tick, 1520U);
}

/// Clock and signal.
class Signal : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(Signal, StopsTheTask) {
  const auto [clock, number] = GetParam();
  MrrocRun run({"run", "tasks/press/press.toml", "--clock", clock});
  ASSERT_TRUE(run.wait_for_output("JointLine")) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  run.signal(number);
  EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
  EXPECT_NE(run.err().find("stopped by the operator"), std::string::npos) << run.err();
  EXPECT_EQ(run.out().find("does not end"), std::string::npos) << run.out();
  EXPECT_EQ(run.out().find("ToolVelocity"), std::string::npos) << run.out();
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(Clocks, Signal,
                         testing::Combine(testing::Values("paced", "real"), testing::Values(SIGINT, SIGTERM)),
                         [](const auto& test) {
                           return std::string{std::get<0>(test.param)} + "_" +
                                  (std::get<1>(test.param) == SIGINT ? "interrupt" : "terminate");
                         });

TEST(Operator, CtrlCTwiceEndsATaskThatNeverWaits) {
  const ScratchFolder folder;
  MrrocRun run({"run", folder.write("endless.toml", faulty_deployment("endless")).string()});
  ASSERT_TRUE(run.wait_for_output("elapsed")) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  run.signal(SIGINT);
  ASSERT_TRUE(run.wait_for_output("stopping (once more to end at once)"));
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
  EXPECT_NE(run.out().find("process arm does not end, killing it"), std::string::npos) << run.out();
  EXPECT_TRUE(all_end(pids));
}

TEST(Operator, CtrlCBeforeTheBarrierEndsAtOnce) {
  for (int seed = 1; seed <= 5; ++seed) {
    MrrocRun run({"run", "tasks/press/press.toml", "--shuffle-start", std::to_string(seed)});
    while (run.children().size() < static_cast<std::size_t>(seed)) std::this_thread::yield();
    run.signal(SIGINT);
    EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
    EXPECT_NE(run.err().find("ended by the operator"), std::string::npos) << run.err();
    EXPECT_EQ(run.out().find("running"), std::string::npos) << run.out();
    EXPECT_EQ(run.out().find("does not end"), std::string::npos) << run.out();
  }
}

}  // namespace
}  // namespace mrroc::test::operator_test
