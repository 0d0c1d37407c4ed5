#include <algorithm>
#include <vector>

#include "config/deployment_fixture.hpp"
#include "config/entries/driver_entry.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::config::broken_deployments_test {
namespace {

/// The first line of every file in broken/, `# expect: ...`, contains the message that the file must give.
class BrokenDeployment : public DeploymentFixture, public testing::WithParamInterface<std::string> {
 protected:
  BrokenDeployment() : DeploymentFixture("broken") {}
};

std::vector<std::string> broken_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(MRROC_SOURCE_DIR "/tests/config/broken")) {
    names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST_P(BrokenDeployment, GivesTheExpectedMessage) {
  const std::string file = GetParam() + ".toml";
  std::string first_line;
  std::ifstream stream(file);
  ASSERT_TRUE(std::getline(stream, first_line));
  ASSERT_TRUE(first_line.starts_with("# expect: ")) << first_line;
  // drivers are found in their folders
  std::vector<std::string> sources{"simulated", "replay"};
  for (const std::string& driver : sensor_drivers("force_torque")) sources.push_back(driver);
  const std::string expected = replaced(first_line.substr(10), "ROBOT_DRIVERS", alternatives(robot_drivers()));
  EXPECT_EQ(message(file), replaced(expected, "SOURCES", alternatives(sources)));
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenDeployment, testing::ValuesIn(broken_files()),
                         [](const auto& test) { return test.param; });

TEST(BrokenDeployments, AreMany) { EXPECT_GE(broken_files().size(), 80u); }

}  // namespace
}  // namespace mrroc::config::broken_deployments_test
