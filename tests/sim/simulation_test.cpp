#include "sim/simulation.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <bit>

#include "mrroc/errors.hpp"
#include "mrroc/fnv.hpp"
#include "reference_dynamics.hpp"
#include "sim/mujoco_allocations.hpp"
#include "worlds.hpp"

namespace mrroc::sim::simulation_test {
namespace {

using config::Deployment;
using config::message_of;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using task_test::ScratchFolder;

class SimulationTest : public testing::Test {
 protected:
  SimulationTest() { setenv("MRROC_SHARE", kData.c_str(), 1); }

  /// A drive that pushes the arm down towards the box and swings it.
  static world::JointDrive swing(Tick tick) {
    const double phase = 0.002 * static_cast<double>(tick);
    world::JointDrive drive =
        drive_of((MatrixXd(2, 2) << 0.4, -0.1, -0.1, 0.2).finished(), 0.5 * MatrixXd::Identity(2, 2),
                 Vector2d(4 * std::sin(3 * phase), -3 * std::cos(2 * phase)), Vector2d::Zero());
    drive.tick = tick;
    return drive;
  }
  world::JointMeasurement measurement(std::size_t robot) const {
    world::JointMeasurement value;
    EXPECT_TRUE(memory_->measurements[robot].load(value));
    return value;
  }
  RawReading reading(std::size_t sensor) const {
    RawReading value;
    EXPECT_TRUE(memory_->readings[sensor].load(value));
    return value;
  }
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
};

TEST_F(SimulationTest, PublishesTickZeroWithEveryRobotAtHome) {
  Simulation simulation(twolink_deployment(2), *memory_);
  simulation.publish_initial();
  for (const std::size_t robot : {0U, 1U}) {
    EXPECT_EQ(measurement(robot).tick, 0U);
    EXPECT_EQ(measurement(robot).position[0], 0.5);
    EXPECT_EQ(measurement(robot).position[1], 0.8);
    EXPECT_EQ(measurement(robot).velocity[0], 0.0);
  }
  EXPECT_EQ(reading(0).tick, 0U);
}

TEST_F(SimulationTest, RangefinderReadsTheDistanceOfTheSameTick) {
  Simulation simulation(twolink_deployment(1), *memory_);
  simulation.publish_initial();
  // the site is 0.9 m high and points down, the table's top is at 0.4 m; the box falls beside it
  EXPECT_EQ(reading(0).count, 1U);
  EXPECT_NEAR(reading(0).values[0], 0.5, 1e-12);
  const mjModel& model = simulation.world().model();
  const int box = model.jnt_qposadr[mj_name2id(&model, mjOBJ_JOINT, "box")];
  simulation.world().data().qpos[box] = 0;
  simulation.world().data().qpos[box + 1] = 1.5;
  simulation.world().data().qpos[box + 2] = 0.6;
  simulation.world().data().qvel[model.jnt_dofadr[mj_name2id(&model, mjOBJ_JOINT, "box")] + 2] = 0;
  for (Tick k = 1; k <= 20; ++k) {
    simulation.step(k);
    const double height = simulation.world().data().qpos[box + 2];
    EXPECT_NEAR(reading(0).values[0], 0.9 - height - 0.05, 1e-12);
    EXPECT_EQ(reading(0).tick, k);
  }
}

TEST_F(SimulationTest, ForceTorqueAtRestReadsTheWeightBeyondTheWrist) {
  Simulation simulation(twolink_deployment(1), *memory_);
  simulation.publish_initial();
  for (Tick k = 0; k <= 10; k += 5) {
    if (k > 0) simulation.step(k);
    const RawReading wrist = reading(1);
    ASSERT_EQ(wrist.count, 6U);
    // hand: 0.5 kg, 0.05 m along the site's z, which is turned by 0.5 + 0.8 from vertical about y
    const double weight = 0.5 * 9.81, angle = 1.3;
    EXPECT_NEAR(wrist.values[0], -weight * std::sin(angle), 1e-6);
    EXPECT_NEAR(wrist.values[1], 0, 1e-6);
    EXPECT_NEAR(wrist.values[2], weight * std::cos(angle), 1e-6);
    EXPECT_NEAR(wrist.values[4], -weight * std::sin(angle) * 0.05, 1e-6);
  }
}

TEST_F(SimulationTest, BrakesHoldWithoutADriveWhenDisabledAndWhenTheDriveExpires) {
  Simulation simulation(twolink_deployment(1), *memory_);
  simulation.publish_initial();
  const auto moved_in_step = [&](Tick tick) {
    const double before = measurement(0).position[0];
    simulation.step(tick);
    return measurement(0).position[0] != before;
  };
  simulation.publish_initial();
  EXPECT_FALSE(moved_in_step(1)) << "no drive command yet";
  world::JointDrive never = swing(0);
  memory_->drives[0].store(never);
  EXPECT_FALSE(moved_in_step(2)) << "tick 0: never attached";
  memory_->drives[0].store(swing(2));
  EXPECT_TRUE(moved_in_step(3));
  world::JointDrive disabled = swing(3);
  disabled.enabled = 0;
  memory_->drives[0].store(disabled);
  EXPECT_FALSE(moved_in_step(4)) << "disabled";
  memory_->drives[0].store(swing(4));
  for (Tick k = 5; k <= 4 + Simulation::kDriveLifetime; ++k) EXPECT_TRUE(moved_in_step(k)) << k;
  EXPECT_FALSE(moved_in_step(5 + Simulation::kDriveLifetime)) << "expired";
}

TEST_F(SimulationTest, NanFromADriveEndsTheSimulation) {
  Simulation simulation(twolink_deployment(1), *memory_);
  simulation.publish_initial();
  world::JointDrive drive = swing(1);
  drive.torque[0] = std::numeric_limits<double>::quiet_NaN();
  memory_->drives[0].store(drive);
  EXPECT_THROW(simulation.step(2), SystemError);
}

TEST_F(SimulationTest, FiveThousandStepsAreEqualBitForBit) {
  const auto run = [] {
    auto memory = std::make_unique<world::WorldMemory>();
    Simulation simulation(twolink_deployment(2), *memory);
    simulation.publish_initial();
    Fnv1a hash;
    const auto add = [&hash](double value) { hash.add(std::bit_cast<std::uint64_t>(value)); };
    for (Tick k = 1; k <= 5000; ++k) {
      for (std::size_t robot = 0; robot < 2; ++robot) memory->drives[robot].store(swing(k + 100 * robot));
      simulation.step(k);
      const World& world = simulation.world();
      for (int i = 0; i < world.model().nq; ++i) add(world.data().qpos[i]);
      for (int i = 0; i < world.model().nsensordata; ++i) add(world.data().sensordata[i]);
    }
    EXPECT_GT(simulation.world().data().ncon, 0) << "the steps must include contacts";
    return hash.value();
  };
  EXPECT_EQ(run(), run());
}

TEST_F(SimulationTest, StepsDoNotAllocate) {
  test::count_mujoco_allocations();
  Simulation simulation(twolink_deployment(2), *memory_);
  simulation.publish_initial();
  std::vector<world::JointDrive> drives;
  for (Tick k = 0; k <= 1100; ++k) drives.push_back(swing(k));
  const auto run = [&](Tick first, Tick last) {
    for (Tick k = first; k <= last; ++k) {
      for (std::size_t robot = 0; robot < 2; ++robot) memory_->drives[robot].store(drives[k]);
      if (k % 50 == 0) memory_->drives[1].store(world::JointDrive{});  // brakes
      simulation.step(k);
    }
  };
  run(1, 100);
  const long before = test::allocations();
  EXPECT_GT(before, 0);
  run(101, 1100);
  EXPECT_EQ(test::allocations() - before, 0);
}

TEST_F(SimulationTest, WorldContainsOnlyMujocoRobotsAndSimulatedSensors) {
  Deployment deployment = twolink_deployment(2);
  deployment.robots[0].driver.world = false;
  deployment.sensors[1].source = "replay";
  Simulation simulation(deployment, *memory_);
  simulation.publish_initial();
  world::JointMeasurement unused;
  EXPECT_FALSE(memory_->measurements[0].load(unused));
  EXPECT_EQ(measurement(1).position[0], 0.5);
  EXPECT_LT(mj_name2id(&simulation.world().model(), mjOBJ_BODY, "a0"), 0);
}

TEST_F(SimulationTest, MissingSensorListsThoseThatExist) {
  Deployment deployment = twolink_deployment(1);
  deployment.sensors[0].name = "door";
  EXPECT_EQ(message_of({}, [&] { Simulation(deployment, *memory_); }),
            "sensors.door: the simulated world has no sensor of this name, expected \"door\" among those that exist: "
            "gate, a0/force_torque/force, a0/force_torque/torque, a0/encoder");
}

TEST_F(SimulationTest, RefusesAnUnconnectedEmergencyStop) {
  Deployment deployment = twolink_deployment(2);
  deployment.robots[1].emergency_stop = 3;
  EXPECT_EQ(
      message_of(kData, [&] { Simulation(deployment, *memory_); }),
      "test.toml: robots.a1.emergency_stop: input_3 is not in the scene, so that it would be pressed permanently, "
      "expected a sensor 'a1/input_3' there or in the robot's MJCF");
  const ScratchFolder scratch;
  deployment.sim->scene = scratch.write(
      "wired.xml",
      "<mujoco><include file='" + (kData / "scene.xml").string() +
          "'/><worldbody><body><joint name='button' type='slide'/><geom size='0.01' mass='0.1'/></body></worldbody>"
          "<sensor><jointpos name='a1/input_3' joint='button'/></sensor></mujoco>");
  EXPECT_NO_THROW(Simulation(deployment, *memory_));
}

TEST_F(SimulationTest, SensorOfARobotIsFoundByItsNameOrItsType) {
  Deployment deployment = twolink_deployment(1);
  deployment.sensors[0].name = "anything";
  deployment.sensors[0].type = "encoder";
  deployment.sensors[0].robot = "a0";
  Simulation simulation(deployment, *memory_);
  simulation.publish_initial();
  EXPECT_EQ(reading(0).values[0], 0.5);
}

TEST_F(SimulationTest, RefusesADeploymentWithoutAWorld) {
  Deployment deployment = twolink_deployment(1);
  deployment.sim.reset();
  EXPECT_THROW(Simulation(deployment, *memory_), config::ConfigurationError);
}

TEST_F(SimulationTest, StatesRoundTripThroughTheirFile) {
  const ScratchFolder scratch;
  Simulation simulation(twolink_deployment(1), *memory_);
  simulation.publish_initial();
  for (Tick k = 1; k <= 7; ++k) simulation.step(k);
  const WorldState state = simulation.state();
  const auto file = scratch.path() / "state";
  save_state(file, simulation.state());
  const WorldState read = load_state(file);
  EXPECT_EQ(read.tick, 7U);
  EXPECT_EQ(read.time, state.time);
  EXPECT_EQ(read.positions, state.positions);
}

TEST_F(SimulationTest, RefusesBrokenStateFiles) {
  const ScratchFolder scratch;
  for (const char* text : {"", "something else\n", "mrroc world state 1\n", "mrroc world state 1\n5 0.1 3\n1\n2\n",
                           "mrroc world state 1\n5 0.1 99999999999\n", "mrroc world state 1\n5 0.1 1\nx\n"}) {
    EXPECT_THROW(load_state(scratch.write("state", text)), config::ConfigurationError) << text;
  }
}

}  // namespace
}  // namespace mrroc::sim::simulation_test
