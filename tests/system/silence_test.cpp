#include <gtest/gtest.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/wait.h>

#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
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
  EXPECT_NE(run.out().find("process "s + name + " does not go on, killing it"), std::string::npos) << run.out();
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(Clocks, Silence,
                         testing::Combine(testing::Values("lockstep", "paced", "real"),
                                          testing::Values("mp", "arm", "arm_edp")),
                         [](const auto& test) {
                           return std::string{std::get<0>(test.param)} + "_" + std::get<1>(test.param);
                         });

/// Holds every thread of a process as a debugger does at a breakpoint: nobody is told, no signal is sent. Until it
/// goes.
class Debugger {
 public:
  explicit Debugger(pid_t pid) {
    for (const auto& thread : std::filesystem::directory_iterator("/proc/" + std::to_string(pid) + "/task")) {
      const pid_t id = std::stoi(thread.path().filename());
      if (ptrace(PTRACE_SEIZE, id, nullptr, nullptr) != 0) continue;  // it ends
      threads_.push_back(id);
      EXPECT_EQ(ptrace(PTRACE_INTERRUPT, id, nullptr, nullptr), 0);
    }
    int status = 0;
    for (const pid_t id : threads_) waitpid(id, &status, __WALL);
  }
  ~Debugger() {
    // the first thread is buried last, and then by the parent
    for (auto id = threads_.rbegin(); id != threads_.rend(); ++id)
      if (ptrace(PTRACE_DETACH, *id, nullptr, nullptr) != 0) waitpid(*id, nullptr, __WALL);
  }
  Debugger(const Debugger&) = delete;
  Debugger& operator=(const Debugger&) = delete;

  std::size_t threads() const { return threads_.size(); }

 private:
  std::vector<pid_t> threads_;
};

class Breakpoint : public testing::TestWithParam<const char*> {};

TEST_P(Breakpoint, WhoStandsThereIsSilentAndTheRestEnds) {
  const ScratchFolder folder;
  MrrocRun run({"run", folder.write("hold.toml", faulty_deployment("hold", GetParam())).string()});
  ASSERT_TRUE(run.wait_for_output("never")) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  {
    const Debugger debugger(run.child("mp"));
    EXPECT_GT(debugger.threads(), 1U);
    EXPECT_EQ(run.wait(), kSystem) << run.out() << run.err();
    EXPECT_NE(run.out().find("process mp is killed, but a debugger"), std::string::npos) << run.out();
  }
  EXPECT_NE(run.err().find("process mp is silent for 1.0"), std::string::npos) << run.out() << run.err();
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(Clocks, Breakpoint, testing::Values("lockstep", "real"),
                         [](const auto& test) { return std::string{test.param}; });

/// It lives and beats; simulated time stands still, under the real clock its robots do.
class Endless : public testing::TestWithParam<std::pair<const char*, std::vector<const char*>>> {};

TEST_P(Endless, WhoComputesWithoutEndIsNamedAndTheOperatorEndsIt) {
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
}  // namespace mrroc::test
