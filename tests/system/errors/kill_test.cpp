#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <tuple>

#include "repetitions.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::kill_test {
namespace {

constexpr int kSystem = 4;

std::set<std::string> shared_memory() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/shm")) names.insert(entry.path().filename());
  return names;
}

/// Waits until the run has started the process `name`; returns -1 when it has ended without it.
pid_t await_child(MrrocRun& run, const std::string& name) {
  pid_t pid = -1;
  while ((pid = run.child(name)) < 0 && !run.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return pid;
}

/// Clock, number of repetitions, and the process to kill.
class Kill : public testing::TestWithParam<std::tuple<std::tuple<const char*, int, int>, const char*>> {};

/// Kills the process `name` of a run `delay` ms after its start.
void kill_one(const std::vector<std::string>& arguments, const std::string& name, std::uint_fast32_t delay) {
  MrrocRun run(arguments);
  const pid_t victim = await_child(run, name);
  ASSERT_GT(victim, 0) << run.out() << run.err();
  std::this_thread::sleep_for(std::chrono::milliseconds(delay));
  const std::vector<pid_t> pids = run.children();
  ASSERT_EQ(kill(victim, SIGKILL), 0);
  EXPECT_EQ(run.wait(), kSystem) << run.out() << run.err();
  EXPECT_NE(run.err().find("process " + name + " died: signal 9 (Killed)"), std::string::npos)
      << run.out() << run.err();
  EXPECT_EQ(run.out().find("does not end"), std::string::npos) << run.out();
  EXPECT_TRUE(all_end(pids));
}

TEST_P(Kill, AnyProcessIsNamedAndTheRestEnds) {
  const auto [clock, usual, thorough] = std::get<0>(GetParam());
  const std::string name = std::get<1>(GetParam());
  const std::set<std::string> before = shared_memory();
  std::mt19937 random(static_cast<unsigned>(name.front()));
  for (int i = 0; i < tries(usual, thorough) && !HasFailure(); ++i) {
    // some die during the start of the deployment, most in the middle of the task
    kill_one({"run", "tasks/press/press.toml", "--clock", clock}, name, random() % 900);
  }
  EXPECT_EQ(shared_memory(), before);
}

const auto kProcesses = testing::Values("mp", "arm", "arm_edp", "wrist", "gate", "sim");

std::string name_of(const testing::TestParamInfo<Kill::ParamType>& test) {
  return std::string{std::get<0>(std::get<0>(test.param))} + "_" + std::get<1>(test.param);
}

INSTANTIATE_TEST_SUITE_P(Simulated, Kill, testing::Combine(testing::Values(std::tuple{"paced", 6, 20}), kProcesses),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Real, Kill, testing::Combine(testing::Values(std::tuple{"real", 3, 5}), kProcesses), name_of);

class KillInLockstep : public testing::TestWithParam<const char*> {};

/// Time runs as fast as it can: most die in the middle of a delta, with messages in flight.
TEST_P(KillInLockstep, AnyProcessIsNamedAndTheRestEnds) {
  const ScratchFolder folder;
  const auto deployment = folder.write("hold.toml", faulty_deployment("hold") +
                                                        "[sensors.gate]\ntype = \"ultrasonic\"\n"
                                                        "mode = \"non-interactive\"\nrate = 500\n"
                                                        "source = \"replay\"\nreplay = \"" MRROC_SOURCE_DIR
                                                        "/tasks/press_replay/gate.txt\"\n");
  std::mt19937 random(1);
  for (int i = 0; i < tries(6, 20) && !HasFailure(); ++i)
    kill_one({"run", deployment.string()}, GetParam(), random() % 600);
}

INSTANTIATE_TEST_SUITE_P(Processes, KillInLockstep, testing::Values("mp", "arm", "arm_edp", "gate"),
                         [](const auto& test) { return std::string{test.param}; });

class KillRunner : public testing::TestWithParam<const char*> {};

TEST_P(KillRunner, NoProcessOutlivesIt) {
  const std::set<std::string> before = shared_memory();
  MrrocRun run({"run", "tasks/press/press.toml", "--clock", GetParam()});
  ASSERT_TRUE(run.wait_for_output("JointLine"));
  const std::vector<pid_t> pids = run.children();
  EXPECT_EQ(pids.size(), 6U);
  run.signal(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  EXPECT_TRUE(all_end(pids));
  EXPECT_EQ(shared_memory(), before);
}

TEST_P(KillRunner, NoProcessOutlivesItBeforeTheBarrier) {
  for (int i = 0; i < 5; ++i) {
    MrrocRun run({"run", "tasks/press/press.toml", "--clock", GetParam()});
    ASSERT_GT(await_child(run, "mp"), 0) << run.out() << run.err();
    std::this_thread::sleep_for(std::chrono::milliseconds(10 * i));
    const std::vector<pid_t> pids = run.children();
    run.signal(SIGKILL);
    EXPECT_EQ(run.wait(), -SIGKILL);
    EXPECT_TRUE(all_end(pids));
  }
}

TEST_P(KillRunner, TaskThatNeverWaitsDoesNotOutliveIt) {
  const ScratchFolder folder;
  MrrocRun run({"run", folder.write("endless.toml", faulty_deployment("endless", GetParam())).string()});
  ASSERT_TRUE(run.wait_for_output("elapsed")) << run.out() << run.err();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // it never waits after this first instruction
  const std::vector<pid_t> pids = run.children();
  EXPECT_EQ(pids.size(), 3U);
  run.signal(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(Clocks, KillRunner, testing::Values("paced", "real"),
                         [](const auto& test) { return std::string{test.param}; });

}  // namespace
}  // namespace mrroc::test::kill_test
