#include <gtest/gtest.h>
#include <signal.h>

#include <string>
#include <tuple>

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

/// It lives and beats, and simulated time stands still.
TEST(Endless, WhoComputesWithoutEndIsNamedAndTheOperatorEndsIt) {
  const ScratchFolder folder;
  MrrocRun run({"run", folder.write("endless.toml", faulty_deployment("endless")).string()});
  ASSERT_TRUE(run.wait_for_output("nothing has happened for 2 s; clock running at tick")) << run.out() << run.err();
  ASSERT_TRUE(run.wait_for_output("; at work: arm\n")) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  run.signal(SIGINT);
  ASSERT_TRUE(run.wait_for_output("once more to end at once")) << run.out() << run.err();
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
  EXPECT_TRUE(all_end(pids));
}

TEST(ZeroTimeLoop, IsAnErrorThatNamesThoseInIt) {
  const ScratchFolder folder;
  const auto deployment = folder.write("zero_time.toml", faulty_deployment("zero_time"));
  const std::string output = run_mrroc({"run", deployment.string()}, kSystem);
  EXPECT_NE(output.find("clock lost: zero-time loop at tick "), std::string::npos) << output;
  EXPECT_NE(output.find("between arm_edp, arm: 1000 deltas"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test
