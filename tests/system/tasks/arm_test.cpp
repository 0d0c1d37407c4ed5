// The stock EDP and class for arms that are chains, in whole deployments.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>

#include "robots/arm/arm_model.hpp"
#include "system/equal_runs.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test::arm_test {
namespace {

const std::filesystem::path kShare = std::filesystem::path(MRROC_SOURCE_DIR) / "tests/robots/arm/share";
const std::filesystem::path kArm = kShare / "robots/bench_arm";

/// Processes find the types of the installation and those of `share`.
void search(const std::filesystem::path& share) {
  setenv("MRROC_SHARE", (share.string() + ":" MRROC_BINARY_DIR "/share/mrroc").c_str(), 1);
}

std::string with(const std::string& text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no '" + from + "'");
  return text.substr(0, at) + to + text.substr(at + from.size());
}

std::string number(double value) { return std::to_string(value); }

TEST(ArmTask, ToursItsWorkspaceEquallyInEveryRun) {
  search(kShare);
  const ScratchFolder folder;
  const EqualRuns runs = expect_equal_runs((kArm / "demo.toml").string(), folder);
  EXPECT_FALSE(steps_where(runs.trace, [](const auto& step) { return step.is_move; }).empty())
      << "the robot has not moved";
}

/// With a controller that follows velocities, and a plant model alone.
TEST(ArmTask, MovesWithEveryInterfaceAndHardware) {
  const ScratchFolder folder;
  for (const char* file : {"bench_arm.xml", "demo.xml"})
    folder.write("robots/bench_arm/" + std::string(file), text_of(kArm / file));
  const std::string demo = text_of(kArm / "demo.toml"), parameters = text_of(kArm / "bench_arm.toml");
  const std::string plant = with(demo.substr(0, demo.find("[sim]")), "\"mujoco\"", "\"loopback\"");
  search(folder.path());
  for (const char* interface : {"position", "velocity"}) {
    folder.write("robots/bench_arm/bench_arm.toml",
                 with(parameters, "bandwidth", std::string("interface = \"") + interface + "\"\nbandwidth"));
    for (const std::string& deployment : {demo, plant})
      run_mrroc(
          {"run", folder.write("robots/bench_arm/run.toml", deployment).string(), "--quiet", "--clock", "lockstep"}, 0);
  }
}

/// A pad on a spring below the tool; the greatest force that the wrist measures against it.
TEST(ArmTask, PressesWithTheForceOfItsTask) {
  search(kShare);
  const RobotModels models = load_arm(kArm / "bench_arm.toml");
  const Eigen::Vector3d tool = models.front()->flange(models.front()->parameters().home).translation();
  const std::string place = number(tool.x()) + " " + number(tool.y()) + " " + number(tool.z() - 0.06);
  const ScratchFolder folder;
  folder.write(
      "press.xml",
      "<mujoco><compiler angle='radian'/><option timestep='0.001' cone='elliptic'/><worldbody><body name='pad' pos='" +
          place +
          "'><joint name='pad' type='slide' axis='0 0 1' stiffness='5000' damping='60'/><geom type='cylinder' "
          "size='0.06 0.01' mass='0.1' solref='0.004 1'/></body></worldbody></mujoco>");
  const auto deployment = folder.write(
      "press.toml",
      "[deployment]\nname = \"press\"\nclock = \"lockstep\"\n[robots.arm]\ntype = \"bench_arm\"\nprogram = "
      "\"" MRROC_BINARY_DIR
      "/tests/press_at_home_ecp\"\nhardware = \"mujoco\"\nforce_sensor = \"wrist\"\n[sensors.wrist]\ntype = "
      "\"force_torque\"\nrobot = \"arm\"\nmode = \"interactive\"\n[sim]\nscene = \"press.xml\"\n");
  const auto trace = folder.path() / "run.mcap";
  run_mrroc({"run", deployment.string(), "--quiet", "--record", trace.string()}, 0);
  double greatest = 0;
  for (const cli::trace::Line& step : steps_of(trace, "Hold")) {
    const cli::trace::Numbers& wrench = step.robots.at(0).wrench;
    if (wrench.size() == 6) greatest = std::max(greatest, std::hypot(wrench[0], wrench[1], wrench[2]));
  }
  EXPECT_GT(greatest, 10);
  EXPECT_LT(greatest, 16);
}

}  // namespace
}  // namespace mrroc::test::arm_test
