#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <set>
#include <thread>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

constexpr int kTimes = 20;

std::set<std::string> shared_memory() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/shm")) names.insert(entry.path().filename());
  return names;
}

bool gone(pid_t pid) { return kill(pid, 0) != 0; }

void expect_gone(const std::vector<pid_t>& pids) {
  for (const pid_t pid : pids) {
    for (int i = 0; i < 400 && !gone(pid); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(gone(pid)) << "process " << pid << " is left behind";
  }
}

class Kill : public testing::TestWithParam<const char*> {};

TEST_P(Kill, AnyProcessIsNamedAndTheRestEnds) {
  const std::string name = GetParam();
  const std::set<std::string> before = shared_memory();
  std::mt19937 random(std::hash<std::string>{}(name) % 1000);
  for (int i = 0; i < kTimes; ++i) {
    MrrocRun run({"run", "tasks/press/press.toml", "--clock", "paced"});
    pid_t victim = -1;
    while ((victim = run.child(name)) < 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    // some die while the deployment is being set up, most in the middle of the task
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 700));
    const std::vector<pid_t> pids = run.children();
    ASSERT_EQ(kill(victim, SIGKILL), 0);
    EXPECT_EQ(run.wait(), 4) << run.out() << run.err();
    EXPECT_NE(run.err().find("process " + name + " died: signal 9 (Killed)"), std::string::npos) << run.err();
    expect_gone(pids);
    if (HasFailure()) return;
  }
  EXPECT_EQ(shared_memory(), before);
}

INSTANTIATE_TEST_SUITE_P(Processes, Kill, testing::Values("mp", "arm", "arm_edp", "wrist", "gate", "sim"),
                         [](const auto& test) { return std::string{test.param}; });

TEST(KillRunner, NoProcessOutlivesIt) {
  MrrocRun run({"run", "tasks/press/press.toml", "--clock", "paced"});
  ASSERT_TRUE(run.wait_for_output("mp           running"));
  const std::vector<pid_t> pids = run.children();
  EXPECT_EQ(pids.size(), 6U);
  run.signal(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  expect_gone(pids);
}

TEST(Silence, AStoppedProcessIsNamed) {
  const ScratchFolder folder;
  const std::string scene = std::string{MRROC_SOURCE_DIR} + "/tasks/press/press.xml";
  const auto deployment = folder.write("silent.toml",
                                       "[deployment]\nname = \"silent\"\nclock = \"paced\"\nheartbeat_timeout = 1.5\n"
                                       "[robots.arm]\ntype = \"irb6\"\nprogram = \"press_ecp\"\nhardware = \"mujoco\"\n"
                                       "position = [0.0, 0.0, 0.7]\n"
                                       "[sensors.wrist]\ntype = \"force_torque\"\nrobot = \"arm\"\n"
                                       "[sensors.gate]\ntype = \"ultrasonic\"\nmode = \"non-interactive\"\nrate = 50\n"
                                       "[sim]\nscene = \"" +
                                           scene + "\"\n");
  MrrocRun run({"run", deployment.string()});
  ASSERT_TRUE(run.wait_for_output("mp           running")) << run.out() << run.err();
  const pid_t victim = run.child("wrist");
  ASSERT_GT(victim, 0);
  kill(victim, SIGSTOP);
  EXPECT_EQ(run.wait(), 4);
  EXPECT_NE(run.err().find("process wrist is silent"), std::string::npos) << run.err();
  expect_gone({victim});
}

}  // namespace
}  // namespace mrroc::test
