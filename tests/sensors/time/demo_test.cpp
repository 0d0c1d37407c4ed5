#include <gtest/gtest.h>

#include "system/equal_runs.hpp"

namespace mrroc::test {
namespace {

constexpr const char* kDemo = "sensors/time/demo.toml";

TEST(TimeDemo, EveryLapEndsAtItsTickOnEveryRun) {
  const ScratchFolder folder;
  for (const std::string& output : expect_equal_runs(kDemo, folder).outputs) {
    EXPECT_NE(output.find("lap of 0.500 s ended at 0.500 s, tick 750"), std::string::npos) << output;
    EXPECT_NE(output.find("lap of 1.500 s ended at 1.500 s, tick 1500"), std::string::npos) << output;
  }
}

TEST(TimeDemo, RunsAlsoInRealTime) {
  const std::string output = run_mrroc({"run", kDemo, "--quiet", "--clock", "real"}, 0);
  EXPECT_NE(output.find("lap of 1.500 s ended at "), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test
