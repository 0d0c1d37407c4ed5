#include <gtest/gtest.h>

#include "system/equal_runs.hpp"

namespace mrroc::test {
namespace {

TEST(ConveyorEncoderDemo, MeasuresABeltOfAnotherProgramEquallyInEveryRun) {
  const ScratchFolder folder;
  for (const std::string& output : expect_equal_runs("sensors/conveyor_encoder/demo.toml", folder).outputs) {
    // at 0.05 m/s a step of 20 ms is 1 mm; the coarse encoder's steps are 50 mm
    EXPECT_NE(output.find("belt at 0.15"), std::string::npos) << output;
    EXPECT_NE(output.find(" m, 0.45 m by the coarse encoder"), std::string::npos) << output;
  }
}

}  // namespace
}  // namespace mrroc::test
