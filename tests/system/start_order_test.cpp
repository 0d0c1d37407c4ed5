#include <gtest/gtest.h>

#include "repetitions.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test::start_order_test {
namespace {

TEST(StartOrder, LaunchesInRandomOrderWithRandomDelaysAllSucceed) {
  const ScratchFolder folder;
  const auto deployment = folder.write("quick.toml",
                                       "[deployment]\nname = \"quick\"\n"
                                       "[robots.left]\ntype = \"irb6\"\nhardware = \"loopback\"\n"
                                       "[robots.right]\ntype = \"irb6\"\nhardware = \"loopback\"\n");
  for (int seed = 1; seed <= tries(15, 50); ++seed) {
    run_mrroc({"run", deployment.string(), "--quiet", "--shuffle-start", std::to_string(seed)}, 0);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

TEST(StartOrder, TaskInMotionInRealTimeSucceedsToo) {
  const ScratchFolder folder;
  const auto deployment = folder.write("caught.toml", faulty_deployment("caught", "real"));
  for (int seed = 1; seed <= tries(5, 10); ++seed) {
    run_mrroc({"run", deployment.string(), "--quiet", "--shuffle-start", std::to_string(seed)}, 0);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace mrroc::test::start_order_test
