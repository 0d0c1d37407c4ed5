#include <gtest/gtest.h>

#include "system/equal_runs.hpp"

namespace mrroc::test::demo_test {
namespace {

/// The demo ends with an error when its cameras' measurements are off by 2 mm.
TEST(CameraDemo, PointsAtMeasuredTargetsEquallyInTwoRuns) {
  const ScratchFolder folder;
  expect_equal_runs("sensors/camera/demo.toml", folder);
}

}  // namespace
}  // namespace mrroc::test::demo_test
