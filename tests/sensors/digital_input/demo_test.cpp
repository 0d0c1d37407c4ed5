#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

// the demo itself throws unless the ball has bounced and the debounced switch has risen once
TEST(DigitalInputDemo, CountsEveryTouchAndDebouncesTheSameWayOnEveryRun) {
  const ScratchFolder folder;
  std::string first;
  for (int run = 0; run < 5; ++run) {
    const auto trace = folder.path() / "trace";
    run_mrroc({"run", "sensors/digital_input/demo.toml", "--quiet", "--clock", "lockstep", "--trace", trace.string()},
              0);
    if (run == 0) first = trace_hash(trace);
    ASSERT_EQ(trace_hash(trace), first) << "run " << run;
  }
}

}  // namespace
}  // namespace mrroc::test
