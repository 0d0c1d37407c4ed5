#include <gtest/gtest.h>

#include "system/mrroc_run.hpp"

namespace mrroc::test::changes_test {
namespace {

/// A valve on output 3 of the arm's controller, which input 0 measures.
constexpr const char* kScene = R"(<mujoco model="terminals">
  <compiler angle="radian"/>
  <worldbody>
    <body name="valve" pos="1 1 1">
      <joint name="valve" type="slide" axis="1 0 0" damping="10"/>
      <geom size="0.02" mass="0.2"/>
    </body>
  </worldbody>
  <actuator>
    <position name="arm/output_3" joint="valve" kp="100" ctrlrange="-0.02 0.05" ctrllimited="true"/>
  </actuator>
  <sensor>
    <jointpos name="arm/input_0" joint="valve"/>
  </sensor>
</mujoco>)";

std::string deployment(const std::string& rest) {
  return "[deployment]\nname = \"changes\"\n[robots.arm]\ntype = \"irb6\"\nprogram = \"" MRROC_BINARY_DIR
         "/tests/changes_ecp\"\n" +
         rest;
}

TEST(Changes, OutputsAndRegulatorsChangeInTheSimulatedWorld) {
  const ScratchFolder folder;
  folder.write("scene.xml", kScene);
  const auto file = folder.write(
      "changes.toml", deployment("hardware = \"mujoco\"\nposition = [0, 0, 0.7]\n[sim]\nscene = \"scene.xml\"\n"));
  const std::string output = run_mrroc({"run", file.string(), "--quiet"}, 0);
  EXPECT_NE(output.find("input 0 came after"), std::string::npos) << output;
  EXPECT_NE(output.find("moved with soft regulators"), std::string::npos) << output;
}

TEST(Changes, UnconnectedInputNeverSwitches) {
  const ScratchFolder folder;
  folder.write("scene.xml", "<mujoco><compiler angle=\"radian\"/></mujoco>");
  const auto file = folder.write(
      "changes.toml", deployment("hardware = \"mujoco\"\nposition = [0, 0, 0.7]\n[sim]\nscene = \"scene.xml\"\n"
                                 "[[events]]\ntick = 2000\ncommand = \"stop\"\n"));
  const std::string output = run_mrroc({"run", file.string(), "--quiet"}, 5);
  EXPECT_EQ(output.find("input 0 came"), std::string::npos) << "not connected: " << output;
}

}  // namespace
}  // namespace mrroc::test::changes_test
