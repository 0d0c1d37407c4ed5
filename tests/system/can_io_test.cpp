// Tasks whose outputs and inputs are CiA 401 nodes on the buses of their robots, in simulation.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "system/equal_runs_on_a_bus.hpp"
#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test {
namespace {

namespace fs = std::filesystem;
const fs::path kTasks = fs::path(MRROC_SOURCE_DIR) / "tasks";

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  ASSERT_NE(place, std::string::npos) << from;
  text.replace(place, from.size(), to);
}

/// The deployment of a task, with absolute paths of these files.
std::string deployment_of(const std::string& task, const std::vector<std::string>& files) {
  std::string text = text_of(kTasks / task / (task + ".toml"));
  for (const std::string& file : files)
    replace(text, "\"" + file + "\"", "\"" + (kTasks / task / file).string() + "\"");
  return text;
}

/// Puts the next robot of `text`, `robot`, on a bus of its own in `folder`, with the I/O nodes of `io`.
void put_on_bus(std::string& text, const ScratchFolder& folder, const std::string& robot, const fs::path& io) {
  replace(text, "hardware = \"mujoco\"", "hardware = \"socketcan\"");
  text += "\n[robots." + robot + ".can]\nsimulated = true\ninterface = \"unix:" + (folder.path() / robot).string() +
          "\"\nio = \"" + io.string() + "\"\n";
}

/// A table of a node with 8 inputs and 8 outputs.
fs::path io_of_16(const ScratchFolder& folder) {
  return folder.write("io.toml",
                      "[[nodes]]\nnode = 40\neds = \"cia401.eds\"\ndigital_inputs = 8\ndigital_outputs = 8\n");
}

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
  expect_equal_runs_on_a_bus(folder.write("teach.toml", text), folder, {"teach succeeded"});
}

}  // namespace
}  // namespace mrroc::test
