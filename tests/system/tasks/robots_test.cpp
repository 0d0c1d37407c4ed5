#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::robots_test {
namespace {

const std::filesystem::path kRobots = std::filesystem::path(MRROC_SOURCE_DIR) / "robots";

/// Every demo of a robot, "<type>/<file>"; a new one is tested without a list.
std::vector<std::string> demos() {
  std::vector<std::string> demos;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kRobots)) {
    if (entry.path().filename().string().ends_with("demo.toml"))
      demos.push_back(entry.path().lexically_relative(kRobots).string());
  }
  std::sort(demos.begin(), demos.end());
  return demos;
}

/// irb6 of irb6/demo.toml, conveyor_fast of conveyor/fast_demo.toml.
std::string name_of(const testing::TestParamInfo<std::string>& test) {
  const std::filesystem::path demo(test.param);
  const std::string stem = demo.stem().string();
  return demo.parent_path().string() + (stem == "demo" ? "" : "_" + stem.substr(0, stem.size() - 5));
}

class Demo : public testing::TestWithParam<std::string> {};

TEST_P(Demo, ToursItsWorkspaceEquallyInEveryRun) {
  const ScratchFolder folder;
  const std::string deployment = "robots/" + GetParam();
  const EqualRuns runs = expect_equal_runs(deployment, folder);
  EXPECT_FALSE(steps_where(runs.trace, [](const auto& step) { return step.is_move; }).empty())
      << "the robot has not moved";
}

INSTANTIATE_TEST_SUITE_P(Robots, Demo, testing::ValuesIn(demos()), name_of);

std::vector<std::string> types() {
  std::vector<std::string> types;
  for (const auto& entry : std::filesystem::directory_iterator(kRobots))
    if (const auto type = entry.path().filename().string(); exists(entry.path() / (type + ".toml")))
      types.push_back(type);
  std::sort(types.begin(), types.end());
  return types;
}

class OwnParameters : public testing::TestWithParam<std::string> {};

/// Another machine of the type needs only a copy of the type's parameters, here with a lower speed limit.
TEST_P(OwnParameters, ParametersBesideTheDeploymentAreSufficient) {
  const ScratchFolder folder;
  const std::string text = text_of(kRobots / GetParam() / (GetParam() + ".toml"));
  const std::regex speed("\nvelocity_max = ([0-9.e+-]+)");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(text, found, speed));
  folder.write("mine.toml", found.prefix().str() + "\nvelocity_max = " + std::to_string(0.9 * std::stod(found[1])) +
                                found.suffix().str());
  const auto deployment =
      folder.write("cell.toml", "[deployment]\nname = \"cell\"\n[robots.mine]\ntype = \"" + GetParam() +
                                    "\"\nparameters = \"mine.toml\"\nhardware = \"loopback\"\n");
  run_mrroc({"run", deployment.string(), "--quiet"}, 0);
}

INSTANTIATE_TEST_SUITE_P(Robots, OwnParameters, testing::ValuesIn(types()),
                         [](const auto& test) { return test.param; });

/// tests/system/programs/unsynchronised.cpp on an IRb-6 whose drives have no known positions.
constexpr const char* kUnsynchronised = R"([deployment]
name = "unsynchronised"
clock = "lockstep"

[robots.arm]
type = "irb6"
program = ")" MRROC_BINARY_DIR R"(/tests/unsynchronised_ecp"
hardware = "loopback"
synchronised = false
)";

TEST(Synchronisation, TaskFindsThePositionsChangesToolAndModelAndWorks) {
  const ScratchFolder folder;
  const auto deployment = folder.write("unsynchronised.toml", kUnsynchronised);
  const std::string output = run_mrroc({"run", deployment.string(), "--quiet"}, 0);
  EXPECT_NE(output.find("before: not synchronised"), std::string::npos) << output;
  EXPECT_NE(output.find("after: synchronised"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test::robots_test
