#include <gtest/gtest.h>

#include "system/equal_runs.hpp"

namespace mrroc::test {
namespace {

// the demo itself throws unless the ball has bounced and the debounced switch has risen once
TEST(DigitalInputDemo, CountsEveryContactAndDebouncesEquallyInEveryRun) {
  const ScratchFolder folder;
  expect_equal_runs("sensors/digital_input/demo.toml", folder);
}

}  // namespace
}  // namespace mrroc::test
