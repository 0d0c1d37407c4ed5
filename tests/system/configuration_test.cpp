// Equation (14) of the paper: a running task configures its sensors, with `mrroc run`.
#include <gtest/gtest.h>

#include <algorithm>

#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"

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

using cli::trace::SensorEntry;

/// How many readings in the steps fit.
template <class Fits>
std::size_t count(const Steps& steps, Fits fits) {
  std::size_t found = 0;
  for (const cli::trace::Line& line : steps)
    found += static_cast<std::size_t>(std::count_if(line.sensors.begin(), line.sensors.end(), fits));
  return found;
}

bool is_of_the_new_one(const SensorEntry& reading) { return reading.configuration == 1 && reading.configured == 1; }

bool is_published_of_the_old_one(const SensorEntry& reading) {
  return reading.mode == cli::trace::SensorMode::published && reading.configuration == 0 && reading.configured != 0;
}

TEST(Configuration, RunningTaskConfiguresItsSensorsAndItsRobot) {
  const ScratchFolder folder;
  folder.write("scene.xml", kScene);
  const std::string file = folder.write("configuration.toml", kDeployment).string();
  for (const std::string clock : {"lockstep", "lockstep", "real"}) {
    const auto trace = folder.path() / (clock == "real"                    ? "real.mcap"
                                        : exists(folder.path() / "0.mcap") ? "1.mcap"
                                                                           : "0.mcap");
    const std::string output = run_mrroc({"run", file, "--quiet", "--clock", clock, "--record", trace.string()}, 0);
    EXPECT_NE(output.find("configuration 0: "), std::string::npos) << output;
    EXPECT_NE(output.find("configuration 1: "), std::string::npos) << output;
    run_mrroc({"trace", "check", trace.string()}, 0);
    const Steps steps = steps_of(trace);
    EXPECT_GT(count(steps, is_of_the_new_one), 100U);
    EXPECT_EQ(count(steps, is_published_of_the_old_one), 0U) << "a reading of the old configuration is in a step";
  }
  EXPECT_EQ(trace_hash(folder.path() / "0.mcap"), trace_hash(folder.path() / "1.mcap"));
}

}  // namespace
}  // namespace mrroc::test::configuration_test
