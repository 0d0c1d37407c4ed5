#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Every robot that has a demo, by the name of its folder: a new one is tested without being named here.
std::vector<std::string> robots_with_a_demo() {
  std::vector<std::string> robots;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(MRROC_SOURCE_DIR) / "robots"))
    if (std::filesystem::exists(entry.path() / "demo.toml")) robots.push_back(entry.path().filename());
  std::sort(robots.begin(), robots.end());
  return robots;
}

class Demo : public testing::TestWithParam<std::string> {};

TEST_P(Demo, ToursItsWorkspaceTheSameWayTwice) {
  const ScratchFolder folder;
  const std::string deployment = "robots/" + GetParam() + "/demo.toml";
  for (const char* run : {"first", "second"})
    run_mrroc({"run", deployment, "--quiet", "--clock", "lockstep", "--trace", (folder.path() / run).string()}, 0);
  EXPECT_EQ(trace_hash(folder.path() / "first"), trace_hash(folder.path() / "second"));
  EXPECT_NE(text_of(folder.path() / "first").find(" move="), std::string::npos) << "nothing has moved";
}

INSTANTIATE_TEST_SUITE_P(Robots, Demo, testing::ValuesIn(robots_with_a_demo()),
                         [](const auto& test) { return test.param; });

/// tests/system/programs/unsynchronised.cpp on an IRb-6 whose drives do not know where they are.
std::string unsynchronised_deployment(const std::string& hardware) {
  std::string text = "[deployment]\nname = \"unsynchronised\"\nclock = \"lockstep\"\n\n[robots.arm]\ntype = \"irb6\"\n";
  text.append("program = \"" MRROC_BINARY_DIR "/tests/unsynchronised_ecp\"\nhardware = \"").append(hardware);
  text.append("\"\nposition = [0.0, 0.0, 0.7]\nsynchronised = false\n");
  if (hardware == "mujoco") text.append("\n[sim]\nscene = \"" MRROC_SOURCE_DIR "/tests/system/programs/empty.xml\"\n");
  return text;
}

class Synchronisation : public testing::TestWithParam<const char*> {};

TEST_P(Synchronisation, ATaskFindsThePositionsChangesToolAndModelAndWorks) {
  const ScratchFolder folder;
  const auto deployment = folder.write("unsynchronised.toml", unsynchronised_deployment(GetParam()));
  const std::string output = run_mrroc({"run", deployment.string(), "--quiet"}, 0);
  EXPECT_NE(output.find("before: not synchronised"), std::string::npos) << output;
  EXPECT_NE(output.find("after: synchronised"), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(Drives, Synchronisation, testing::Values("loopback", "mujoco"),
                         [](const auto& test) { return std::string{test.param}; });

}  // namespace
}  // namespace mrroc::test
