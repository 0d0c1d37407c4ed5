#include "mrroc/testing/run.hpp"

#include <gtest/gtest.h>

#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::task_test {
namespace {

/// A command in place of `mrroc` that writes this trace to its argument after `--trace`.
RunResult run_that_writes(const std::string& trace, const std::string& rest = "") {
  const ScratchFolder folder;
  const auto command = folder.write(
      "mrroc", "#!/bin/sh\nwhile [ \"$1\" != --trace ]; do shift; done\ncat > \"$2\" <<END\n" + trace + "END\n" + rest);
  std::filesystem::permissions(command, std::filesystem::perms::owner_all);
  return DeploymentRun(command, "some.toml").run();
}

TEST(DeploymentRun, TickOfAStepIsNotThatOfItsReadings) {
  const auto run = run_that_writes(
      "mrroc trace\n"
      "tick=248 process=arm move=\"to the left\" step=3 robot=arm tick=240 end=condition\n");
  ASSERT_EQ(run.steps.size(), 1u) << run.output;
  EXPECT_EQ(run.steps[0].tick, 248u);
  EXPECT_EQ(run.steps[0].process, "arm");
  EXPECT_EQ(run.steps[0].instruction, "to the left");
  EXPECT_EQ(run.steps[0].step, 3u);
}

}  // namespace
}  // namespace mrroc::task_test
