#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "free_port.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::deployment_test {
namespace {

/// The task `press` whose wrist is a Net F/T, with these keys.
std::string press_with(const std::string& keys) {
  std::ifstream file(MRROC_SOURCE_DIR "/tasks/press/press.toml");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string wrist = "[sensors.wrist]\n";
  text.insert(text.find(wrist) + wrist.size(), "source = \"netft\"\nnetft = { " + keys + " }\n");
  text.replace(text.find("\"press.xml\""), 11, "\"" MRROC_SOURCE_DIR "/tasks/press/press.xml\"");
  return text.replace(text.find("clock = \"lockstep\""), 18, "clock = \"real\"");
}

/// Real sockets between the sensor's process and the simulated box, which measures in the simulated world.
TEST(NetftDeployment, PressSucceedsWithASimulatedNetFt) {
  const ScratchFolder folder;
  const auto file = folder.write("press.toml", press_with("address = \"127.0.0.1\", simulated = true, port = " +
                                                          free_port(SOCK_DGRAM) + ", http_port = " + free_port()));
  MrrocRun run({"run", file.string(), "--quiet", "--black-box", ""});
  EXPECT_EQ(run.wait(), 0) << run.out() << run.err();
}

TEST(NetftDeployment, ASensorThatIsNotThereIsNamed) {
  const ScratchFolder folder;
  const auto file = folder.write(
      "press.toml", press_with("address = \"127.0.0.1\", start_timeout = 0.2, http_port = " + free_port()));
  MrrocRun run({"run", file.string(), "--quiet", "--black-box", ""});
  EXPECT_NE(run.wait(), 0);
  EXPECT_NE(run.err().find("127.0.0.1"), std::string::npos) << run.err();
}

}  // namespace
}  // namespace mrroc::test::deployment_test
