// Drives that need longer than a process may be silent: at the start, after a fault, and when the run ends meanwhile.
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "system/mrroc_run.hpp"

namespace mrroc::test::power_up_test {
namespace {

constexpr int kStopped = 5;  // exit code

/// An arm whose drives need `power` s to be switched on and to clear the fault that they report at tick `fault`; its
/// ECP may be silent for 1 s.
std::filesystem::path deployment(const ScratchFolder& folder, const std::string& clock, const std::string& power,
                                 int fault = 0) {
  return folder.write("slow_power.toml",
                      "[deployment]\nname = \"slow_power\"\nclock = \"" + clock +
                          "\"\nheartbeat_timeout = 1.0\n"
                          "[robots.arm]\ntype = \"irb6\"\nhardware = \"slow\"\nslow = { power_time = " +
                          power + ", fault_tick = " + std::to_string(fault) +
                          " }\nprogram = \"" MRROC_BINARY_DIR "/tests/slow_power_ecp\"\n");
}

class PowerUp : public testing::TestWithParam<const char*> {
 protected:
  const ScratchFolder folder_;
};

TEST_P(PowerUp, TaskWaitsForTheDrives) {
  const std::string output = run_mrroc({"run", deployment(folder_, GetParam(), "4.0").string(), "--quiet"}, 0);
  EXPECT_NE(output.find("moved"), std::string::npos) << output;
  EXPECT_NE(output.find("the drives are being switched on"), std::string::npos) << output;
}

TEST_P(PowerUp, RecoveryWaitsForTheDrives) {
  const std::string output = run_mrroc({"run", deployment(folder_, GetParam(), "2.0", 1100).string(), "--quiet"}, 0);
  EXPECT_NE(output.find("recovered"), std::string::npos) << output;
  EXPECT_NE(output.find("moved"), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(Clocks, PowerUp, testing::Values("lockstep", "real"));

TEST(PowerUpEnd, RobotThatWaitsForItsDrivesHasStopped) {
  const ScratchFolder folder;
  MrrocRun run({"run", deployment(folder, "real", "1000.0").string(), "--quiet"});
  EXPECT_TRUE(run.wait_for_output("the drives are being switched on")) << run.out() << run.err();
  run.signal(SIGINT);
  EXPECT_TRUE(run.wait_for_output("stopping (once more to end at once)"));
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
  EXPECT_EQ((run.out() + run.err()).find("not every robot has stopped"), std::string::npos) << run.err();
}

TEST(PowerUpOrders, AreRefusedMeanwhileAndExecutedAfterwards) {
  const ScratchFolder folder;
  setenv("MRROC_RUNTIME_DIR", (folder.path() / "runtime").c_str(), 1);
  MrrocRun run({"run", deployment(folder, "real", "4.0").string(), "--quiet", "--hold"});
  EXPECT_TRUE(run.wait_for_output("the drives are being switched on")) << run.out() << run.err();
  const auto order = [](std::vector<std::string> arguments) {
    MrrocRun verb(arguments);
    const int code = verb.wait();
    return std::pair{code, verb.out() + verb.err()};
  };
  const auto early = order({"step", "arm", "1", "0.02"});
  EXPECT_NE(early.first, 0);
  EXPECT_NE(early.second.find("the drives are being switched on"), std::string::npos) << early.second;
  std::pair<int, std::string> late = early;
  for (int i = 0; i < 100 && late.second.find("the drives are being switched on") != std::string::npos; ++i)
    late = order({"step", "arm", "1", "0.02"});
  EXPECT_EQ(late.first, 0) << late.second;
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
  unsetenv("MRROC_RUNTIME_DIR");
}

}  // namespace
}  // namespace mrroc::test::power_up_test
