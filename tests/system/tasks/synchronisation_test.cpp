// Robots that start without known positions, in the simulated world, as run by a user.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <sstream>

#include "config/deployment.hpp"
#include "config/robot_parameters_file.hpp"
#include "sim/simulation.hpp"
#include "sim/state_file.hpp"
#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test::synchronisation_test {
namespace {

constexpr int kPatience = 1000;  // s: minutes of simulated time
const std::filesystem::path kRobots = std::filesystem::path(MRROC_SOURCE_DIR) / "robots";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("no " + from);
  return text.replace(at, from.size(), to);
}

/// The demo's deployment of a robot with another program, which must synchronise it first.
std::string unsynchronised(const std::string& robot) {
  std::string text = text_of(kRobots / robot / "demo.toml");
  text = replaced(text, std::string("\"").append(robot).append("_demo\"\nhardware"),
                  "\"" MRROC_BINARY_DIR "/tests/synchronise_ecp\"\nsynchronised = false\nhardware");
  return replaced(text, "\"demo.xml\"", std::string("\"").append(kRobots / robot / "demo.xml").append("\""));
}

/// The first robot's joints in the last state that a run has saved.
std::vector<double> joints_in_the_world(const std::filesystem::path& deployment, const std::filesystem::path& states) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(states)) files.push_back(entry.path());
  const sim::WorldState state = sim::load_state(*std::max_element(files.begin(), files.end()));
  const auto memory = std::make_unique<world::WorldMemory>();
  setenv("MRROC_PROGRAMS", MRROC_BINARY_DIR "/bin", 1);  // they lie beside `mrroc`, not beside this test
  const config::Deployment loaded = config::load_deployment(deployment);
  sim::Simulation simulation(loaded, *memory);
  const config::RobotEntry& robot = loaded.robots.front();
  std::vector<double> joints;
  const auto parameters =
      config::read_robot_parameters(config::Table::load(config::robot_file(robot.type, robot.type + ".toml")));
  for (const AxisParameters& axis : parameters.axes) {
    const mjModel& model = simulation.world().model();
    const int joint = mj_name2id(&model, mjOBJ_JOINT, (robot.name + "/" + axis.name).c_str());
    joints.push_back(state.positions.at(static_cast<std::size_t>(model.jnt_qposadr[joint])));
  }
  return joints;
}

class Synchronisation : public testing::TestWithParam<std::string> {};

/// Runs `text` in the simulated world: the robot finds its positions and moves to its target.
void expect_synchronisation(const ScratchFolder& folder, const std::string& text) {
  const auto deployment = folder.write("unsynchronised.toml", text);
  const auto states = folder.path() / "states";
  const std::string output =
      run_mrroc({"run", deployment.string(), "--quiet", "--snapshots", states.string()}, 0, kPatience);
  std::istringstream lines(output);
  std::vector<double> target;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("synchronised in") != std::string::npos) std::cout << line << "\n";
    const std::size_t at = line.find("target ");
    if (at == std::string::npos) continue;
    std::istringstream numbers(line.substr(at + 7));
    for (double number = 0; numbers >> number;) target.push_back(number);
  }
  const std::vector<double> joints = joints_in_the_world(deployment, states);
  ASSERT_EQ(target.size(), joints.size()) << output;
  for (std::size_t i = 0; i < joints.size(); ++i) EXPECT_NEAR(joints[i], target[i], 5e-4) << "axis " << i;
}

TEST_P(Synchronisation, FromHomeInTheSimulatedWorldItFindsItsPositionsAndGoesWhereItIsSent) {
  const ScratchFolder folder;
  expect_synchronisation(folder, unsynchronised(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Robots, Synchronisation,
                         testing::Values("irb6", "irb6_track", "irb6_five_axis", "irb60", "serial_parallel",
                                         "two_finger_gripper"),
                         [](const auto& test) { return test.param; });

TEST(SynchronisationOnABus, DrivesFindThePositionsAndTheRobotReachesItsTarget) {
  const ScratchFolder folder;
  const std::string text = replaced(unsynchronised("irb6"), "\"mujoco\"", "\"socketcan\"");
  expect_synchronisation(folder, text + "\n[robots.arm.can]\nsimulated = true\ninterface = \"unix:" +
                                     (folder.path() / "bus").string() + "\"\n");
}

class WithoutSwitches : public testing::TestWithParam<std::string> {};

TEST_P(WithoutSwitches, UnsynchronisedStartIsRefusedBeforeAnythingStarts) {
  const ScratchFolder folder;
  const auto deployment = folder.write("unsynchronised.toml", unsynchronised(GetParam()));
  const std::string output = run_mrroc({"run", deployment.string(), "--quiet"}, 2);
  EXPECT_NE(output.find(".synchronised: false, but axis '"), std::string::npos) << output;
  EXPECT_NE(output.find("has no switch to find its position by"), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(Robots, WithoutSwitches, testing::Values("conveyor", "polycrank"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace mrroc::test::synchronisation_test
