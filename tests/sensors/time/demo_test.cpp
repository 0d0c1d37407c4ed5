#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

constexpr const char* kDemo = "sensors/time/demo.toml";

TEST(TimeDemo, EveryLapEndsAtItsTickOnEveryRun) {
  const ScratchFolder folder;
  std::string first;
  for (int run = 0; run < 5; ++run) {
    const auto trace = folder.path() / "trace";
    const std::string output =
        run_mrroc({"run", kDemo, "--quiet", "--clock", "lockstep", "--trace", trace.string()}, 0);
    EXPECT_NE(output.find("lap of 0.500 s ended at 0.500 s, tick 750"), std::string::npos) << output;
    EXPECT_NE(output.find("lap of 1.500 s ended at 1.500 s, tick 1500"), std::string::npos) << output;
    if (run == 0) first = trace_hash(trace);
    ASSERT_EQ(trace_hash(trace), first) << "run " << run;
  }
}

TEST(TimeDemo, RunsInRealTimeToo) {
  const std::string output = run_mrroc({"run", kDemo, "--quiet", "--clock", "real"}, 0);
  EXPECT_NE(output.find("lap of 1.500 s ended at "), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test
