#include <gtest/gtest.h>
#include <stdlib.h>

#include <memory>

#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "sim/simulation.hpp"
#include "worlds.hpp"

namespace mrroc::sim::snapshot_test {
namespace {

using config::message_of;
using task_test::ScratchFolder;

config::SensorEntry camera_entry() {
  config::SensorEntry camera;
  camera.name = "eye";
  camera.type = "any type with this parameter";
  camera.texts["camera"] = "";
  return camera;
}

class Snapshot : public testing::Test {
 protected:
  Snapshot() { setenv("MRROC_SHARE", kData.c_str(), 1); }
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
};

TEST_F(Snapshot, IsStoredAtEveryTickForACamera) {
  auto deployment = twolink_deployment(1);
  deployment.sensors.push_back(camera_entry());
  Simulation simulation(deployment, *memory_);
  simulation.publish_initial();
  world::WorldSnapshot snapshot;
  for (Tick tick = 0; tick < 20; ++tick) {
    if (tick > 0) simulation.step(tick);
    ASSERT_TRUE(memory_->snapshot.load(snapshot));
    EXPECT_EQ(snapshot.tick, tick);
    const std::vector<double> positions = simulation.state().positions;
    ASSERT_EQ(snapshot.position_count, positions.size());
    EXPECT_TRUE(std::equal(positions.begin(), positions.end(), snapshot.values.begin()));
  }
}

TEST_F(Snapshot, IsNotStoredWithoutAUser) {
  Simulation simulation(twolink_deployment(1), *memory_);
  simulation.publish_initial();
  simulation.step(1);
  world::WorldSnapshot snapshot;
  EXPECT_FALSE(memory_->snapshot.load(snapshot));
  EXPECT_EQ(memory_->snapshot.sequence(), 0U);
}

TEST_F(Snapshot, IsNotStoredForACameraOfHardware) {
  auto deployment = twolink_deployment(1);
  deployment.sensors.push_back(camera_entry());
  deployment.sensors.back().source = "hardware";
  Simulation simulation(deployment, *memory_);
  simulation.publish_initial();
  EXPECT_EQ(memory_->snapshot.sequence(), 0U);
}

TEST_F(Snapshot, ContainsThePosesOfMocapBodies) {
  const ScratchFolder scratch;
  config::Deployment deployment;
  deployment.sensors = {camera_entry()};
  deployment.sim.emplace();
  deployment.sim->scene = scratch.write("scene.xml", R"(<mujoco><compiler angle="radian"/><worldbody>
<body name="a" mocap="true" pos="1 2 3"><geom size="0.1"/></body>
<body name="box" pos="0 0 5"><joint type="slide"/><geom size="0.1" mass="1"/></body>
<body name="b" mocap="true" pos="4 5 6" quat="0 1 0 0"><geom size="0.1"/></body></worldbody></mujoco>)");
  Simulation simulation(deployment, *memory_);
  simulation.publish_initial();
  world::WorldSnapshot snapshot;
  ASSERT_TRUE(memory_->snapshot.load(snapshot));
  EXPECT_EQ(snapshot.position_count, 1U);
  EXPECT_EQ(snapshot.mocap_count, 2U);
  const std::vector<double> expected{0, 1, 2, 3, 4, 5, 6, 1, 0, 0, 0, 0, 1, 0, 0};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), snapshot.values.begin()));
}

TEST_F(Snapshot, RefusesAWorldThatIsTooLarge) {
  const ScratchFolder scratch;
  std::string bodies;
  for (int i = 0; i < 147; ++i) bodies += "<body><freejoint/><geom size='0.1' mass='1' contype='0'/></body>\n";
  config::Deployment deployment;
  deployment.sensors = {camera_entry()};
  deployment.sim.emplace();
  deployment.sim->scene =
      scratch.write("scene.xml", "<mujoco><compiler angle='radian'/><worldbody>" + bodies + "</worldbody></mujoco>");
  EXPECT_EQ(message_of({}, [&] { Simulation(deployment, *memory_); }),
            "sensors.eye: views a world with 1029 positions, expected at most 1024");
}

}  // namespace
}  // namespace mrroc::sim::snapshot_test
