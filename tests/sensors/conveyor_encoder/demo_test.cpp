#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

TEST(ConveyorEncoderDemo, WatchesABeltThatAnotherProgramDrivesTheSameWayOnEveryRun) {
  const ScratchFolder folder;
  std::string first;
  for (int run = 0; run < 5; ++run) {
    const auto trace = folder.path() / "trace";
    const std::string output = run_mrroc(
        {"run", "sensors/conveyor_encoder/demo.toml", "--quiet", "--clock", "lockstep", "--trace", trace.string()}, 0);
    // at 0.05 m/s a step of 20 ms is 1 mm; the coarse encoder's steps are 50 mm
    EXPECT_NE(output.find("belt at 0.15"), std::string::npos) << output;
    EXPECT_NE(output.find(" m, 0.45 m by the coarse encoder"), std::string::npos) << output;
    if (run == 0) first = trace_hash(trace);
    ASSERT_EQ(trace_hash(trace), first) << "run " << run;
  }
}

}  // namespace
}  // namespace mrroc::test
