#pragma once

#include <gtest/gtest.h>

#include "mrroc/testing/run.hpp"

namespace mrroc::task_test {

/// A GoogleTest fixture for a user's own task. It runs a deployment in lockstep, with real processes, links and
/// physics, injects faults at ticks or steps, and checks what the robots did. `mrroc_add_task_test` in CMake builds
/// such a test (docs/how-to/fault-injection.md):
///
///     using Press = mrroc::task_test::DeploymentTest;
///
///     TEST_F(Press, StopsWhenItsEcpDies) {
///       const auto run = deployment("press.toml").inject("kill ecp:arm at step 120").run();
///       EXPECT_EQ(run.exit_code, 4);
///       expect_safe(run);
///     }
class DeploymentTest : public ::testing::Test {
 protected:
  /// A run of this deployment file; a relative path is relative to the folder of the test's CMakeLists.txt.
  static DeploymentRun deployment(const std::filesystem::path& file) {
    return {MRROC_COMMAND, std::filesystem::path(MRROC_TEST_FOLDER) / file};
  }

  /// Checks that at the end every robot of the simulated world is at rest, no robot has exceeded a limit, that of
  /// velocity by more than `tolerance` of it, and no process remains. Fails when there is no robot. After a fault by
  /// which a motor does not obey or its encoder reports wrong positions (`freeze`, `disconnect`, `runaway`, `jump` of
  /// an EDP) the tolerance is kDisobedience.
  static void expect_safe(const RunResult& run, double tolerance = kOvershoot) {
    EXPECT_EQ(run.leftovers, std::vector<std::string>{}) << run.output;
    EXPECT_FALSE(run.motion.empty()) << "no motion was recorded\n" << run.output;
    for (const auto& [robot, motion] : run.motion) {
      EXPECT_FALSE(motion.ticks.empty()) << robot << " has not been recorded\n" << run.output;
      EXPECT_NE(motion.standstill(), kNever) << robot << " moved to the end\n" << run.output;
      EXPECT_EQ(motion.limits_exceeded(tolerance), std::vector<std::string>{}) << robot << "\n" << run.output;
    }
  }
};

}  // namespace mrroc::task_test
