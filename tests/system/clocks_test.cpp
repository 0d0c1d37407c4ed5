#include <gtest/gtest.h>

#include <fstream>

#include "system/mrroc_run.hpp"

namespace mrroc::test::clocks_test {
namespace {

/// The last line of each instruction: its name and the conditions that held.
std::vector<std::string> endings_of(const std::filesystem::path& trace) {
  std::vector<std::string> endings;
  std::ifstream file(trace);
  for (std::string line; std::getline(file, line);) {
    if (line.find(" end=") == std::string::npos) continue;
    const std::size_t name = line.find_first_of('"');
    const std::size_t conditions = line.find(" condition=");
    endings.push_back(line.substr(name, line.find('"', name + 1) - name + 1) +
                      (conditions == std::string::npos ? "" : line.substr(conditions)));
  }
  return endings;
}

class Clocks : public testing::TestWithParam<const char*> {};

TEST_P(Clocks, SameBinariesGiveTheSameOutcome) {
  const ScratchFolder folder;
  const auto lockstep = folder.path() / "lockstep";
  const auto other = folder.path() / "other";
  run_mrroc({"run", "tasks/press/press.toml", "--clock", "lockstep", "--quiet", "--trace", lockstep.string()}, 0);
  const std::string output =
      run_mrroc({"run", "tasks/press/press.toml", "--clock", GetParam(), "--trace", other.string()}, 0);
  EXPECT_EQ(endings_of(other), endings_of(lockstep));
  EXPECT_EQ(endings_of(other).size(), 6U);
  EXPECT_NE(output.find("press succeeded"), std::string::npos) << output;
  if (std::string{GetParam()} == "real") {
    for (const char* word : {" ticks, ", " missed, ", " late commands", "wake-up p50 ", " p99 ", " max "}) {
      EXPECT_NE(output.find(word), std::string::npos) << word << " is missing in\n" << output;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Wall, Clocks, testing::Values("paced", "real"));

}  // namespace
}  // namespace mrroc::test::clocks_test
