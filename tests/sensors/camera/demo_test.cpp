#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

/// The demo ends with an error when what its cameras see is off by 2 mm.
TEST(CameraDemo, PointsAtWhatItsCamerasSeeTheSameWayTwice) {
  const ScratchFolder folder;
  std::string first;
  for (int run = 0; run < 2; ++run) {
    const std::filesystem::path trace = folder.path() / ("trace_" + std::to_string(run));
    run_mrroc({"run", "sensors/camera/demo.toml", "--quiet", "--trace", trace.string()}, 0);
    if (run == 0) first = trace_hash(trace);
    EXPECT_EQ(trace_hash(trace), first);
  }
}

}  // namespace
}  // namespace mrroc::test
