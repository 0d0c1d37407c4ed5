// Equation (14) of the paper: a running task configures its sensors, with `mrroc run`.
#include <gtest/gtest.h>

#include <fstream>

#include "system/mrroc_run.hpp"

namespace mrroc::test::configuration_test {
namespace {

constexpr const char* kScene = R"(<mujoco model="configuration">
  <compiler angle="radian"/>
  <worldbody>
    <geom name="floor" type="plane" size="4 4 0.1"/>
    <body name="transducer" pos="1.5 1.5 0.8"><site name="gate" zaxis="0 0 -1"/></body>
  </worldbody>
  <sensor><rangefinder name="gate" site="gate"/></sensor>
</mujoco>)";

constexpr const char* kDeployment = R"([deployment]
name = "configuration"
[robots.arm]
type = "irb6"
hardware = "mujoco"
position = [0.0, 0.0, 0.7]
force_sensor = "wrist"
program = ")" MRROC_BINARY_DIR R"(/tests/configured_sensors_ecp"
[sensors.wrist]
type = "force_torque"
robot = "arm"
tool_mass = 0.1
tool_centre = [0.004, 0.0, 0.066]
cutoff = 5.0
[sensors.gate]
type = "ultrasonic"
mode = "non-interactive"
rate = 10
[sim]
scene = "scene.xml"
)";

std::size_t count(const std::filesystem::path& file, const std::string& word) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++found;
  return found;
}

TEST(Configuration, RunningTaskConfiguresItsSensorsAndItsRobot) {
  const ScratchFolder folder;
  folder.write("scene.xml", kScene);
  const std::string file = folder.write("configuration.toml", kDeployment).string();
  for (const std::string clock : {"lockstep", "lockstep", "real"}) {
    const auto trace = folder.path() / (clock == "real" ? "real" : exists(folder.path() / "0") ? "1" : "0");
    const std::string output = run_mrroc({"run", file, "--quiet", "--clock", clock, "--trace", trace.string()}, 0);
    EXPECT_NE(output.find("configuration 0: "), std::string::npos) << output;
    EXPECT_NE(output.find("configuration 1: "), std::string::npos) << output;
    run_mrroc({"trace", "check", trace.string()}, 0);
    EXPECT_GT(count(trace, " configuration=1 configured=1"), 100U);
    EXPECT_EQ(count(trace, " published configured=1"), 0U) << "a reading of the old configuration is in a step";
  }
  EXPECT_EQ(trace_hash(folder.path() / "0"), trace_hash(folder.path() / "1"));
}

}  // namespace
}  // namespace mrroc::test::configuration_test
