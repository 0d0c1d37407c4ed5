#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::clocks_test {
namespace {

/// The last step of each instruction: its name, its conditions with their values, and how it ended.
std::vector<std::string> endings_of(const std::filesystem::path& trace) {
  std::vector<std::string> endings;
  for (const cli::trace::Line& line : steps_of(trace)) {
    if (!line.ends()) continue;
    std::string text = line.name;
    for (const cli::trace::ConditionEntry& condition : line.conditions)
      text += ", " + condition.name + (condition.value ? ": 1" : ": 0");
    endings.push_back(text + ", ending " + std::to_string(static_cast<int>(line.ending)));
  }
  return endings;
}

class Clocks : public testing::TestWithParam<const char*> {};

TEST_P(Clocks, SameBinariesGiveTheSameOutcome) {
  const ScratchFolder folder;
  const auto lockstep = folder.path() / "lockstep.mcap";
  const auto other = folder.path() / "other.mcap";
  run_mrroc({"run", "tasks/press/press.toml", "--clock", "lockstep", "--quiet", "--record", lockstep.string()}, 0);
  const std::string output =
      run_mrroc({"run", "tasks/press/press.toml", "--clock", GetParam(), "--record", other.string()}, 0);
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
