#include "config/deployment.hpp"

#include <cmath>
#include <limits>

#include "config/deployment_fixture.hpp"
#include "config/entries/operator_answer.hpp"
#include "config/resources.hpp"
#include "geometry/rigid_motion.hpp"

namespace mrroc::config::deployment_test {
namespace {

class DeploymentTest : public DeploymentFixture {
 protected:
  DeploymentTest() : DeploymentFixture("valid") {}

  static std::filesystem::path here(const std::string& name) { return std::filesystem::current_path() / name; }
};

TEST_F(DeploymentTest, ReadsTheGeneralSections) {
  const Deployment deployment = load_deployment("full.toml");
  EXPECT_EQ(deployment.file, here("full.toml"));
  EXPECT_EQ(deployment.name, "press_2");
  EXPECT_EQ(deployment.clock, ClockMode::paced);
  EXPECT_EQ(deployment.servo_period, 0.001);
  EXPECT_EQ(deployment.domain, 17);
  EXPECT_EQ(deployment.start_timeout, 12.5);
  EXPECT_EQ(deployment.heartbeat_timeout, 2);
  EXPECT_EQ(deployment.delta_limit, 50u);
  EXPECT_EQ(deployment.mp.program, program("press_mp"));
  ASSERT_TRUE(deployment.sim);
  EXPECT_EQ(deployment.sim->scene, here("scene.xml"));
  EXPECT_EQ(deployment.sim->timestep, 0.0005);
  EXPECT_EQ(deployment.sim->program, program("mrroc_sim"));
}

TEST_F(DeploymentTest, ReadsFeeders) {
  const Deployment deployment = load_deployment("full.toml");
  ASSERT_EQ(deployment.sim->feeders.size(), 1u);
  const FeederEntry& infeed = deployment.sim->feeders[0];
  EXPECT_EQ(infeed.name, "infeed");
  EXPECT_EQ(infeed.parts, (std::vector<std::string>{"brick", "cube"}));
  EXPECT_EQ(infeed.position, (std::array{0.5, -1.25, 0.75}));
  EXPECT_EQ(infeed.spread, (std::array{0.125, 0.25, 0.0}));
  EXPECT_EQ(infeed.turn, 0.5);
  EXPECT_EQ(infeed.first, 1.5);
  EXPECT_EQ(infeed.interval, (std::array{2.5, 4.0}));
  EXPECT_EQ(infeed.seed, 7u);
}

TEST_F(DeploymentTest, ReadsRobotsInFileOrder) {
  const Deployment deployment = load_deployment("full.toml");
  ASSERT_EQ(deployment.robots.size(), 2u);
  const RobotEntry& left = deployment.robots[0];
  EXPECT_EQ(left.name, "left");
  EXPECT_EQ(left.type, "irb6");
  EXPECT_EQ(left.program, program("press_ecp"));
  EXPECT_EQ(left.edp_program, program("irb6_edp"));
  EXPECT_EQ(left.driver.name, "mujoco");
  EXPECT_EQ(left.host, "");  // localhost is this machine
  EXPECT_EQ(left.mount, "");
  const RobotEntry& belt = deployment.robots[1];
  EXPECT_EQ(belt.name, "belt");
  EXPECT_EQ(belt.program, program("mrroc_ecp"));
  EXPECT_EQ(belt.driver.name, "loopback");
  EXPECT_EQ(belt.mount, "left");
  EXPECT_TRUE(belt.base.isApprox(Pose::Identity()));
}

TEST_F(DeploymentTest, RobotsWithSwitchesMayStartUnsynchronised) {
  const task_test::ScratchFolder scratch;
  const std::string text = "[deployment]\nname = \"one\"\n[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\n";
  EXPECT_TRUE(load_deployment(scratch.write("known.toml", text)).robot("arm").synchronised);
  EXPECT_FALSE(load_deployment(scratch.write("lost.toml", text + "synchronised = false\n")).robot("arm").synchronised);
}

TEST_F(DeploymentTest, AnInputMayBeTheEmergencyStopOfARobot) {
  const task_test::ScratchFolder scratch;
  const std::string text = "[deployment]\nname = \"one\"\n[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\n";
  EXPECT_FALSE(load_deployment(scratch.write("none.toml", text)).robot("arm").emergency_stop);
  const auto file = scratch.write("input.toml", text + "emergency_stop = 15\n");
  EXPECT_EQ(load_deployment(file).robot("arm").emergency_stop, 15);
}

TEST_F(DeploymentTest, AMeasuredBaseIsKnownBesideTheOneOfTheSimulation) {
  const task_test::ScratchFolder scratch;
  const std::string text =
      "[deployment]\nname = \"one\"\n[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\nposition = [1, 2, 3]\n";
  const RobotEntry placed = load_deployment(scratch.write("placed.toml", text)).robot("arm");
  EXPECT_TRUE(placed.known_base().isApprox(placed.base));
  const auto file = scratch.write("measured.toml", text + "base_position = [1, 2, 3.5]\nbase_rotation = [0, 0, 0.5]\n");
  const RobotEntry measured = load_deployment(file).robot("arm");
  EXPECT_TRUE(measured.base.isApprox(placed.base));
  EXPECT_TRUE(measured.known_base().isApprox(pose_from_rpy({1, 2, 3.5}, {0, 0, 0.5})));
}

TEST_F(DeploymentTest, TurnsTheBaseAboutFixedAxes) {
  const Pose base = load_deployment("full.toml").robot("left").base;
  EXPECT_EQ(base.translation(), Eigen::Vector3d(0.5, -1, 0.25));
  // roll about x, then pitch about the world's y, then yaw about the world's z: followed by hand on the x and z axes
  const double roll = 0.1, pitch = -0.2, yaw = 1.5;
  const Eigen::Vector3d x(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), -std::sin(pitch));
  EXPECT_TRUE(base.linear().col(0).isApprox(x, 1e-12));
  EXPECT_NEAR(base.linear()(2, 2), std::cos(roll) * std::cos(pitch), 1e-12);
  EXPECT_NEAR(base.linear()(2, 1), std::sin(roll) * std::cos(pitch), 1e-12);
  EXPECT_NEAR(base.linear().determinant(), 1, 1e-12);
}

TEST_F(DeploymentTest, ReadsSensorsWithTheirOwnParameters) {
  const Deployment deployment = load_deployment("full.toml");
  ASSERT_EQ(deployment.sensors.size(), 2u);
  const SensorEntry& wrist = deployment.sensors[0];
  EXPECT_EQ(wrist.name, "wrist");
  EXPECT_EQ(wrist.type, "force_torque");
  EXPECT_EQ(wrist.robot, "left");
  EXPECT_TRUE(wrist.interactive);
  EXPECT_EQ(wrist.rate, 0);
  EXPECT_EQ(wrist.source, "simulated");
  EXPECT_EQ(wrist.vsp_program, program("force_torque_vsp"));
  EXPECT_TRUE(wrist.numbers.empty());
  EXPECT_TRUE(wrist.texts.empty());
  const SensorEntry& gate = deployment.sensors[1];
  EXPECT_EQ(gate.robot, "");
  EXPECT_FALSE(gate.interactive);
  EXPECT_DOUBLE_EQ(gate.rate, 1000.0 / 3);  // 333.333 Hz: every third period, exactly
  EXPECT_EQ(gate.source, "replay");
  EXPECT_EQ(gate.replay, here("readings.txt"));
  using Numbers = std::map<std::string, std::vector<double>>;
  EXPECT_EQ(gate.numbers,
            (Numbers{{"range", {2.5}}, {"beam", {0.1, 0.2}}, {"mount", {1, 2, 3}}, {"curve", {4, 5, 6, 7}}}));
  EXPECT_EQ(gate.texts, (std::map<std::string, std::string>{{"label", "gate"}}));
}

TEST_F(DeploymentTest, SortsEventsByTick) {
  const auto events = load_deployment("full.toml").events;
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[0].tick, 100u);
  EXPECT_EQ(events[0].command, "pause");
  EXPECT_EQ(events[1].tick, 500u);
  EXPECT_EQ(events[1].command, "resume");
  EXPECT_EQ(events[2].command, "trigger");
}

TEST_F(DeploymentTest, AnswerGoesToASensorThatAsksTheOperator) {
  const task_test::ScratchFolder scratch;
  const auto file = scratch.write("asks.toml", R"([deployment]
name = "asks"
[sensors.parts]
type = "operator_input"
max = 10
[[events]]
tick = 300
command = "answer"
sensor = "parts"
value = 2.5
)");
  const Deployment deployment = load_deployment(file);
  ASSERT_EQ(deployment.events.size(), 1u);
  EXPECT_EQ(deployment.events[0].tick, 300u);
  EXPECT_EQ(deployment.events[0].command, "answer");
  EXPECT_EQ(deployment.events[0].asker, "parts");
  EXPECT_EQ(deployment.events[0].value, 2.5);
  const SensorEntry& parts = deployment.sensor("parts");
  EXPECT_TRUE(asks_operator(parts));
  EXPECT_TRUE(is_answer(parts, -100) && is_answer(parts, 10));
  EXPECT_FALSE(is_answer(parts, -100.5) || is_answer(parts, 10.5));
  EXPECT_FALSE(is_answer(parts, std::numeric_limits<double>::quiet_NaN()));
}

TEST_F(DeploymentTest, ReplayedSensorNeedsNoOperator) {
  SensorEntry played;
  played.type = "operator_input";
  played.source = "replay";
  EXPECT_FALSE(asks_operator(played));
}

TEST_F(DeploymentTest, MostKeysAreOptional) {
  const Deployment deployment = load_deployment("minimal.toml");
  EXPECT_EQ(deployment.clock, ClockMode::lockstep);
  EXPECT_EQ(deployment.servo_period, 0.002);
  EXPECT_EQ(deployment.domain, -1);
  EXPECT_EQ(deployment.start_timeout, 30);
  EXPECT_EQ(deployment.heartbeat_timeout, 5);
  EXPECT_EQ(deployment.delta_limit, 1000u);
  EXPECT_EQ(deployment.mp.program, program("mrroc_mp"));
  EXPECT_FALSE(deployment.sim);
  EXPECT_TRUE(deployment.sensors.empty());
  EXPECT_TRUE(deployment.events.empty());
}

TEST_F(DeploymentTest, ReadsSensorsWithoutRobots) {
  const Deployment deployment = load_deployment("sensors_only.toml");
  EXPECT_EQ(deployment.sim->scene, here("scene.xml"));
  EXPECT_EQ(deployment.sensor("gate").numbers.at("range"), std::vector<double>{4});
  EXPECT_EQ(deployment.sensor("gate").texts.at("label"), "range finder");
}

TEST_F(DeploymentTest, FindsEntriesByName) {
  const Deployment deployment = load_deployment("full.toml");
  EXPECT_EQ(&deployment.robot("belt"), &deployment.robots[1]);
  EXPECT_EQ(&deployment.sensor("gate"), &deployment.sensors[1]);
  const auto folder = std::filesystem::current_path();
  EXPECT_EQ(message_of(folder, [&] { deployment.robot("gate"); }),
            "full.toml: robots: no robot 'gate', expected 'left' or 'belt'");
  EXPECT_EQ(message_of(folder, [&] { deployment.sensor("left"); }),
            "full.toml: sensors: no sensor 'left', expected 'wrist' or 'gate'");
}

TEST_F(DeploymentTest, AcceptsProgramsByPath) {
  const task_test::ScratchFolder scratch;
  const auto file = [&](const std::string& path) {
    return scratch.write("cell/d.toml",
                         "deployment.name = 'one'\nrobots.arm.type = 'irb6'\n"
                         "robots.arm.hardware = 'loopback'\nrobots.arm.program = '" +
                             path + "'\n");
  };
  const auto own = scratch.write("bin/own_ecp", "");
  std::filesystem::permissions(own, std::filesystem::perms::owner_all);
  EXPECT_EQ(load_deployment(file("../bin/own_ecp")).robots[0].program, own);
  EXPECT_EQ(load_deployment(file(own)).robots[0].program, own);
}

TEST_F(DeploymentTest, NamesTheMissingStockProgram) {
  std::filesystem::remove(program("mrroc_mp"));
  EXPECT_EQ(message("minimal.toml"),
            "minimal.toml:1: mp: no program 'mrroc_mp', expected the executable PROGRAMS/mrroc_mp");
  EXPECT_EQ(message("full.toml"), "");
  std::filesystem::remove(program("mrroc_sim"));
  EXPECT_EQ(message("full.toml"),
            "full.toml:13: sim: no program 'mrroc_sim', expected the executable PROGRAMS/mrroc_sim");
}

TEST_F(DeploymentTest, CarriedRobotMayPrecedeItsCarrierAndCarryOthers) {
  const task_test::ScratchFolder scratch;
  const auto robot = [](const std::string& name, const std::string& mount) {
    return "[robots." + name + "]\ntype = 'irb6'\nhardware = 'loopback'\n" +
           (mount.empty() ? "" : "mount = '" + mount + "'\n");
  };
  const Deployment deployment = load_deployment(scratch.write(
      "d.toml", "deployment.name = 'one'\n" + robot("fingers", "hand") + robot("hand", "arm") + robot("arm", "")));
  EXPECT_EQ(deployment.robot("fingers").mount, "hand");
  EXPECT_EQ(deployment.robot("hand").mount, "arm");
}

TEST_F(DeploymentTest, AcceptsTheLongestNameAndTheLargestFleets) {
  const task_test::ScratchFolder scratch;
  const std::string text = "[deployment]\nname = '" + std::string(31, 'x') + "'\n[sim]\nscene = 'scene.xml'\n";
  scratch.write("scene.xml", "");
  for (const auto& [robots, sensors] : {std::pair{16, 26}, {13, 32}}) {  // 60 processes
    std::string fleet = text;
    for (int i = 0; i < robots; ++i)
      fleet.append("[robots.r").append(std::to_string(i)).append("]\ntype = 'irb6'\nhardware = 'mujoco'\n");
    for (int i = 0; i < sensors; ++i)
      fleet.append("[sensors.s").append(std::to_string(i)).append("]\ntype = 'force_torque'\n");
    const Deployment deployment = load_deployment(scratch.write("d.toml", fleet));
    EXPECT_EQ(deployment.robots.size(), static_cast<std::size_t>(robots));
    EXPECT_EQ(deployment.sensors.size(), static_cast<std::size_t>(sensors));
  }
}

}  // namespace
}  // namespace mrroc::config::deployment_test
