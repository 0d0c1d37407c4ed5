#include "cli/robot/import/demo_files.hpp"

#include <spdlog/fmt/fmt.h>

namespace mrroc::cli {

namespace {

constexpr double kPedestal = 0.7;         // height, of the reach
constexpr std::size_t kLongestName = 31;  // of a deployment
constexpr double kGap = 0.01;             // m, from the pedestal to the base: shapes of links may reach below it

/// The name of a deployment is short, that of a type need not be.
std::string deployment_name(const std::string& type, const std::string& program) {
  return type.substr(0, kLongestName - 1 - program.size()) + "_" + program;
}

/// With the arm on its pedestal; `program`: of the stock programs mrroc_arm_...
std::string deployment(const std::string& type, double reach, const char* program, const char* clock,
                       const char* more) {
  return fmt::format(R"([deployment]
name = "{5}"
clock = "{2}"

[robots.arm]
type = "{0}"
program = "mrroc_arm_{1}"
hardware = "mujoco"
position = [0.0, 0.0, {3:.3f}]  # m; the pedestal's height

{4}[sim]
scene = "demo.xml"
)",
                     type, program, clock, demo_height(reach), more, deployment_name(type, program));
}

}  // namespace

double demo_height(double reach) { return kPedestal * reach; }

std::string demo_deployment(const std::string& type, double reach) {
  return fmt::format("# A tour of the workspace of {}. Run it: mrroc run demo.toml\n", type) +
         deployment(type, reach, "demo", "lockstep", "");
}

std::string external_deployment(const std::string& type, double reach) {
  return fmt::format(
             "# {} follows the trajectories of other programs: of 'mrroc follow arm FILE', and of MoveIt by the "
             "action\n"
             "# /arm/follow_joint_trajectory. Run it: mrroc run external.toml; end it: mrroc trigger\n",
             type) +
         deployment(type, reach, "external", "paced", "[ros2]\ncommands = true\n\n");
}

std::string demo_scene(const std::string& type, double reach) {
  const double height = demo_height(reach);
  return fmt::format(R"(<!-- A pedestal under the arm. -->
<mujoco model="{0}_demo">
  <compiler angle="radian"/>
  <option timestep="0.001"/>
  <visual>
    <headlight ambient="0.35 0.35 0.35" diffuse="0.35 0.35 0.35" specular="0.1 0.1 0.1"/>
    <quality offsamples="4" shadowsize="4096"/>
    <global offwidth="1280" offheight="960"/>
  </visual>
  <asset>
    <texture name="sky" type="skybox" builtin="gradient" rgb1="0.82 0.87 0.93" rgb2="0.98 0.98 1.0" width="256" height="256"/>
    <texture name="tiles" type="2d" builtin="checker" rgb1="0.80 0.80 0.80" rgb2="0.72 0.72 0.72" width="256" height="256"/>
    <material name="floor" texture="tiles" texrepeat="8 8"/>
  </asset>
  <worldbody>
    <light name="lamp" directional="true" pos="0 0 4" dir="-0.25 0.45 -1" diffuse="0.55 0.55 0.55" castshadow="true"/>
    <geom name="floor" type="plane" size="{1:.3f} {1:.3f} 0.1" material="floor"/>
    <camera name="main" pos="{2:.3f} {3:.3f} {4:.3f}" xyaxes="0.72 0.69 0 -0.25 0.26 0.93" fovy="46"/>
    <geom name="pedestal" type="cylinder" size="{5:.3f} {6:.4f}" pos="0 0 {6:.4f}" rgba="0.35 0.38 0.42 1"/>
  </worldbody>
</mujoco>
)",
                     type, 4 * reach, 1.45 * reach, -1.35 * reach, height + 0.7 * reach, 0.1 * reach,
                     (height - kGap) / 2 > 0 ? (height - kGap) / 2 : height / 2);
}

}  // namespace mrroc::cli
