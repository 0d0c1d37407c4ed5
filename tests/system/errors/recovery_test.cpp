// A fault of a robot in the simulated world, and the recovery from it, in a user's task.
#include <gtest/gtest.h>

#include "system/block_scene.hpp"
#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::recovery_test {
namespace {

std::string deployment(const std::string& name) {
  return "[deployment]\nname = \"" + name + R"("
clock = "lockstep"

[robots.arm]
type = "irb6"
program = ")" MRROC_BINARY_DIR R"(/tests/recover_ecp"
hardware = "mujoco"
position = [0.0, 0.0, 0.7]

[sim]
scene = "block.xml"
)";
}

TEST(Recovery, AnArmThatMeetsABlockStopsRecoversAndGoesHome) {
  const ScratchFolder folder;
  folder.write("block.xml", kBlockScene);
  const auto file = folder.write("recover.toml", deployment("recover"));
  const std::string output = run_mrroc({"run", file.string(), "--quiet"}, 0);
  EXPECT_NE(output.find("stopped: hardware error: "), std::string::npos) << output;
  EXPECT_NE(output.find("| recovered"), std::string::npos) << output;
}

TEST(Recovery, AFaultThatNobodyCatchesEndsTheRunAndIsInTheBlackBox) {
  const ScratchFolder folder;
  folder.write("block.xml", kBlockScene);
  const auto file = folder.write("uncaught.toml", deployment("uncaught"));
  const std::string output =
      run_mrroc({"run", file.string(), "--quiet", "--black-box", (folder.path() / "boxes").string()}, 3);
  const auto box = folder.path() / "boxes" / "uncaught-arm.mcap";
  EXPECT_NE(output.find("; black box: " + box.string()), std::string::npos) << output;
  expect_laws(box);
  const Steps steps = steps_of(box);
  ASSERT_EQ(steps.size(), 50U);
  const cli::trace::RobotEntry* const arm = robot_in(steps.back(), "arm");
  ASSERT_NE(arm, nullptr);
  EXPECT_EQ(arm->error, ErrorClass::hardware);
  EXPECT_EQ(arm->error_code, "the following error is too large");
  EXPECT_EQ(steps.back().ending, StepEnding::hardware_error);
}

}  // namespace
}  // namespace mrroc::test::recovery_test
