// A fault of a robot in the simulated world, and the way back from it, as a user's task has them.
#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

constexpr const char* kDeployment = R"([deployment]
name = "recover"
clock = "lockstep"

[robots.arm]
type = "irb6"
program = ")" MRROC_BINARY_DIR R"(/tests/recover_ecp"
hardware = "mujoco"
position = [0.0, 0.0, 0.7]

[sim]
scene = "block.xml"
)";

/// A block whose top is 40 mm below the tip of the arm at home.
constexpr const char* kScene = R"(<mujoco>
  <compiler angle="radian"/>
  <worldbody>
    <geom name="floor" type="plane" size="4 4 0.1"/>
    <geom name="block" type="box" size="0.1 0.1 0.33" pos="0.75 0 0.33"/>
  </worldbody>
</mujoco>
)";

TEST(Recovery, AnArmThatMeetsABlockStopsRecoversAndGoesHome) {
  const ScratchFolder folder;
  folder.write("block.xml", kScene);
  const auto deployment = folder.write("recover.toml", kDeployment);
  const std::string output = run_mrroc({"run", deployment.string(), "--quiet"}, 0);
  EXPECT_NE(output.find("stopped: hardware error: "), std::string::npos) << output;
  EXPECT_NE(output.find("| recovered"), std::string::npos) << output;
}

}  // namespace
}  // namespace mrroc::test
