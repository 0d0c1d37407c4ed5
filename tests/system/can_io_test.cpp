// Tasks whose outputs and inputs are CiA 401 nodes on the buses of their robots, in simulation.
#include <gtest/gtest.h>

#include <string>

#include "repetitions.hpp"
#include "system/equal_runs_on_a_bus.hpp"
#include "system/io_on_bus.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::can_io_test {
namespace {

TEST(CanIo, EngravingExtendsItsStylusByAnIoNode) {
  const ScratchFolder folder;
  std::string text = deployment_of("engraving", {"states.toml", "engraving.xml"});
  put_on_bus(text, folder, "machine", kTasks / "engraving/engraving_io.toml");
  expect_equal_runs_on_a_bus(folder.write("engraving.toml", text), folder, {"touched 44 times", "engraving succeeded"});
}

TEST(CanIo, IoNodesLeaveRunsInLockstepEqual) {
  const ScratchFolder folder;
  std::string text = deployment_of("press", {"press.xml"});
  put_on_bus(text, folder, "arm", io_of_16(folder));
  expect_equal_runs_on_a_bus(folder.write("press.toml", text), folder, {"press succeeded: 9.342 s"});
}

TEST(CanIo, EngravingWithoutTheOutputOfItsStylusStops) {
  const ScratchFolder folder;
  std::string text = deployment_of("engraving", {"states.toml", "engraving.xml"});
  const auto io = folder.write("io.toml", "[[nodes]]\nnode = 32\neds = \"cia401.eds\"\nanalog_outputs = 1\n");
  put_on_bus(text, folder, "machine", io);
  const std::string output = run_mrroc({"run", folder.write("engraving.toml", text).string()}, 3);
  EXPECT_NE(output.find("no node has digital output 0, which is switched on"), std::string::npos) << output;
}

/// The arm's lamp and button, and the person's eyes and hand, are terminals on two buses.
TEST(CanIo, TeachRunsWithTheTerminalsOfBothRobotsOnTheirBuses) {
  const ScratchFolder folder;
  std::string text = deployment_of("teach", {"teach.xml"});
  const auto io = io_of_16(folder);
  put_on_bus(text, folder, "arm", io);
  put_on_bus(text, folder, "person", io);
  const auto file = folder.write("teach.toml", text);
  for (int i = 0; i < tries(1, 2); ++i) {
    const std::string output = run_mrroc({"run", file.string()}, 0, MrrocRun::kLongPatience);
    EXPECT_NE(output.find("teach succeeded"), std::string::npos) << output;
  }
}

}  // namespace
}  // namespace mrroc::test::can_io_test
