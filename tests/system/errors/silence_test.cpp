#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "mrroc/testing/motion.hpp"
#include "system/held_threads.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::silence_test {
namespace {

using namespace std::string_literals;

constexpr int kSystem = 4;
constexpr int kStopped = 5;

/// Clock and process.
class Silence : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Silence, AStoppedProcessIsNamedAndTheRestEnds) {
  const auto [clock, name] = GetParam();
  const ScratchFolder folder;
  const auto deployment = folder.write("hold.toml", faulty_deployment("hold", clock));
  MrrocRun run({"run", deployment.string()});
  ASSERT_TRUE(run.wait_for_output("never")) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  ASSERT_EQ(kill(run.child(name), SIGSTOP), 0);
  EXPECT_EQ(run.wait(), kSystem) << run.out() << run.err();
  EXPECT_NE(run.err().find("process "s + name + " is stopped by signal 19 (Stopped (signal))"), std::string::npos)
      << run.out() << run.err();
  EXPECT_NE(run.out().find("process "s + name + " does not continue, killing it"), std::string::npos) << run.out();
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(Clocks, Silence,
                         testing::Combine(testing::Values("lockstep", "paced", "real"),
                                          testing::Values("mp", "arm", "arm_edp")),
                         [](const auto& test) {
                           return std::string{std::get<0>(test.param)} + "_" + std::get<1>(test.param);
                         });

class Breakpoint : public testing::TestWithParam<const char*> {};

TEST_P(Breakpoint, ProcessHeldByDebuggerIsReportedSilent) {
  const ScratchFolder folder;
  MrrocRun run({"run", folder.write("hold.toml", faulty_deployment("hold", GetParam())).string()});
  ASSERT_TRUE(run.wait_for_output("never")) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  {
    const HeldThreads debugger(run.child("mp"));
    EXPECT_GT(debugger.count(), 1U);
    EXPECT_EQ(run.wait(), kSystem) << run.out() << run.err();
    EXPECT_NE(run.out().find("process mp is killed, but a debugger"), std::string::npos) << run.out();
  }
  EXPECT_NE(run.err().find("process mp is silent for 1 s"), std::string::npos) << run.out() << run.err();
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(Clocks, Breakpoint, testing::Values("lockstep", "real"),
                         [](const auto& test) { return std::string{test.param}; });

/// The runner of a task whose arm moves, under the real clock; at the end that arm is at rest.
class Runner : public testing::Test {
 protected:
  /// Waits until the arm moves to the part.
  void await_motion() {
    ASSERT_TRUE(run_.wait_for_output("JointLine")) << run_.out() << run_.err();
    while (fastest() < kMoving && !run_.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }

  /// The greatest speed of any joint in the last second, rad/s.
  double fastest() const {
    const task_test::Motion arm = task_test::read_motion(motion_).at("arm");
    double fastest = 0;
    for (std::size_t k = arm.ticks.size() - std::min<std::size_t>(arm.ticks.size(), 500); k < arm.ticks.size(); ++k)
      fastest = std::max(fastest, arm.velocities[k].cwiseAbs().maxCoeff());
    return fastest;
  }

  void expect_that_the_arm_has_braked() const {
    const task_test::Motion arm = task_test::read_motion(motion_).at("arm");
    EXPECT_GE(fastest(), kMoving) << "it must be in motion";
    EXPECT_NE(arm.standstill(), kNever) << "it moved to the end";
    EXPECT_EQ(arm.limits_exceeded(), std::vector<std::string>{});
  }

  static constexpr double kMoving = 0.1;
  ScratchFolder folder_;
  std::filesystem::path motion_ = folder_.path() / "motion";
  MrrocRun run_{{"run", "tasks/press/press.toml", "--clock", "real", "--motion", motion_.string()}};
};

TEST_F(Runner, StoppedRunnerLeavesNoRobotInMotion) {
  ASSERT_NO_FATAL_FAILURE(await_motion());
  const std::vector<pid_t> pids = run_.children();
  EXPECT_EQ(pids.size(), 6U);
  run_.signal(SIGSTOP);
  const auto stopped = std::chrono::steady_clock::now();
  EXPECT_TRUE(all_end(pids));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - stopped;
  std::printf("all have left after %.3f s\n", taken.count());
  EXPECT_LT(taken.count(), 4) << "the kernel notifies them within 20 ms, and they brake";
  expect_that_the_arm_has_braked();
  run_.signal(SIGCONT);
  EXPECT_EQ(run_.wait(), kSystem) << run_.out() << run_.err();
  EXPECT_NE(run_.err().find("mrroc: press: mrroc run itself was stopped by a signal: "), std::string::npos)
      << run_.out() << run_.err();
}

TEST_F(Runner, StoppedAndKilledRunnerLeavesNothing) {
  ASSERT_NO_FATAL_FAILURE(await_motion());
  const std::vector<pid_t> pids = run_.children();
  run_.signal(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // robots are braking, processes about to leave
  run_.signal(SIGKILL);
  EXPECT_EQ(run_.wait(), -SIGKILL);
  EXPECT_TRUE(all_end(pids));
}

TEST_F(Runner, RunnerHeldByDebuggerForSecondsContinues) {
  ASSERT_NO_FATAL_FAILURE(await_motion());
  {
    const HeldThreads debugger(run_.pid());
    EXPECT_GT(debugger.count(), 1U);
    std::this_thread::sleep_for(std::chrono::seconds(7));
  }
  EXPECT_EQ(run_.wait(), 0) << run_.out() << run_.err();
}

/// It lives and sends heartbeats; simulated time stands still, under the real clock its robots do.
class Endless : public testing::TestWithParam<std::pair<const char*, std::vector<const char*>>> {};

TEST_P(Endless, ComputingProcessIsNamedAndTheOperatorEndsIt) {
  const auto& [clock, texts] = GetParam();
  const ScratchFolder folder;
  MrrocRun run({"run", folder.write("endless.toml", faulty_deployment("endless", clock)).string()});
  for (const char* text : texts) ASSERT_TRUE(run.wait_for_output(text)) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  run.signal(SIGINT);
  ASSERT_TRUE(run.wait_for_output("once more to end at once")) << run.out() << run.err();
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(
    Clocks, Endless,
    testing::Values(std::pair{"lockstep",
                              std::vector{"nothing has happened for 2 s; clock running at tick", "; at work: arm\n"}},
                    std::pair{"real", std::vector{"arm has waited for nothing for 2 s: it computes, or is blocked"}}),
    [](const auto& test) { return std::string{test.param.first}; });

TEST(ZeroTimeLoop, IsAnErrorThatNamesThoseInIt) {
  const ScratchFolder folder;
  const auto deployment = folder.write("zero_time.toml", faulty_deployment("zero_time"));
  const std::string output = run_mrroc({"run", deployment.string()}, kSystem);
  EXPECT_NE(output.find("clock lost: zero-time loop at tick "), std::string::npos) << output;
  EXPECT_NE(output.find("between arm_edp, arm: 1000 deltas"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test::silence_test
