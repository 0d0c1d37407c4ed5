#include <gtest/gtest.h>

#include <algorithm>

#include "system/equal_runs.hpp"
#include "text_of.hpp"

namespace mrroc::test {
namespace {

/// Every robot that has a demo, by the name of its folder: a new one is tested without being named here.
std::vector<std::string> robots_with_a_demo() {
  std::vector<std::string> robots;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(MRROC_SOURCE_DIR) / "robots"))
    if (std::filesystem::exists(entry.path() / "demo.toml")) robots.push_back(entry.path().filename());
  std::sort(robots.begin(), robots.end());
  return robots;
}

class Demo : public testing::TestWithParam<std::string> {};

TEST_P(Demo, ToursItsWorkspaceTheSameWay) {
  const ScratchFolder folder;
  const std::string deployment = "robots/" + GetParam() + "/demo.toml";
  const EqualRuns runs = expect_equal_runs(deployment, folder);
  EXPECT_NE(text_of(runs.trace).find(" move="), std::string::npos) << "nothing has moved";
}

INSTANTIATE_TEST_SUITE_P(Robots, Demo, testing::ValuesIn(robots_with_a_demo()),
                         [](const auto& test) { return test.param; });

/// tests/system/programs/unsynchronised.cpp on an IRb-6 whose drives do not know where they are.
constexpr const char* kUnsynchronised = R"([deployment]
name = "unsynchronised"
clock = "lockstep"

[robots.arm]
type = "irb6"
program = ")" MRROC_BINARY_DIR R"(/tests/unsynchronised_ecp"
hardware = "loopback"
synchronised = false
)";

TEST(Synchronisation, ATaskFindsThePositionsChangesToolAndModelAndWorks) {
  const ScratchFolder folder;
  const auto deployment = folder.write("unsynchronised.toml", kUnsynchronised);
  const std::string output = run_mrroc({"run", deployment.string(), "--quiet"}, 0);
  EXPECT_NE(output.find("before: not synchronised"), std::string::npos) << output;
  EXPECT_NE(output.find("after: synchronised"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test
