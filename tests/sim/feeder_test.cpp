#include "sim/feeder.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <map>

#include "sim/mujoco_allocations.hpp"
#include "sim/simulation.hpp"
#include "worlds.hpp"

namespace mrroc::sim::feeder_test {
namespace {

/// Three overlapping bricks far above a floor.
constexpr const char* kScene = R"(<mujoco>
<compiler angle="radian"/>
<worldbody>
  <geom name="floor" type="plane" size="4 4 0.1"/>
  <body name="a" pos="3 0 2"><freejoint/><geom type="box" size="0.05 0.03 0.02" mass="0.3"/></body>
  <body name="b" pos="3 0.01 2"><freejoint/><geom type="box" size="0.05 0.03 0.02" mass="0.3"/></body>
  <body name="c" pos="3 0.02 2"><freejoint/><geom type="box" size="0.05 0.03 0.02" mass="0.3"/></body>
  <body name="post" pos="-3 0 2"><geom size="0.1"/></body>
</worldbody>
</mujoco>)";

class FeederTest : public testing::Test {
 protected:
  FeederTest() {
    deployment_.file = scratch_.path() / "test.toml";
    deployment_.sim.emplace();
    deployment_.sim->scene = scratch_.write("scene.xml", kScene);
    config::FeederEntry infeed;
    infeed.name = "infeed";
    infeed.parts = {"b", "a", "c"};
    infeed.position = {0.5, -0.5, 0.0205};
    infeed.spread = {0.6, 0.4, 0};
    infeed.turn = 0.6;
    infeed.first = 0.1;
    infeed.interval = {0.2, 0.4};
    deployment_.sim->feeders = {infeed};
  }
  config::FeederEntry& infeed() { return deployment_.sim->feeders[0]; }

  struct Fed {
    Tick tick;
    double x, y, turn;
    bool operator==(const Fed&) const = default;
  };
  /// Tick at which each brick left the pile, and its position one tick later; 1000 ticks of 2 ms.
  std::map<std::string, Fed> run() {
    Simulation simulation(deployment_, *memory_);
    std::map<std::string, Fed> fed;
    for (Tick tick = 1; tick <= 1000; ++tick) {
      simulation.step(tick);
      for (const char* name : {"a", "b", "c"}) {
        const double* q = position(simulation, name);
        if (fed.contains(name) || q[0] > 2) continue;
        fed[name] = {tick, q[0], q[1], 2 * std::atan2(q[6], q[3])};
      }
    }
    for (const char* name : {"a", "b", "c"}) resting_[name] = position(simulation, name)[2];
    return fed;
  }
  static const double* position(Simulation& simulation, const std::string& name) {
    const mjModel& model = simulation.world().model();
    const int joint = model.body_jntadr[mj_name2id(&model, mjOBJ_BODY, name.c_str())];
    return simulation.world().data().qpos + model.jnt_qposadr[joint];
  }
  std::string refusal() {
    return config::message_of(scratch_.path(), [&] { Simulation(deployment_, *memory_); });
  }

  task_test::ScratchFolder scratch_;
  config::Deployment deployment_;
  std::map<std::string, double> resting_;  ///< heights at the end of `run`
  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
};

TEST_F(FeederTest, PlacesThePartsInOrderWithinSpreadAndInterval) {
  const auto fed = run();
  ASSERT_EQ(fed.size(), 3u);
  EXPECT_EQ(fed.at("b").tick, 51u) << "0.1 s, detected one tick later";
  for (const auto& [before, after] : {std::pair{"b", "a"}, {"a", "c"}}) {
    EXPECT_GE(fed.at(after).tick, fed.at(before).tick + 100);
    EXPECT_LE(fed.at(after).tick, fed.at(before).tick + 200);
  }
  for (const auto& [name, place] : fed) {
    EXPECT_NEAR(place.x, 0.5, 0.6) << name;
    EXPECT_NEAR(place.y, -0.5, 0.4) << name;
    EXPECT_NEAR(place.turn, 0, 0.6) << name;
    EXPECT_NEAR(resting_.at(name), 0.02, 1e-3) << name << " lies on the floor";
  }
  EXPECT_NE(fed.at("a").x, fed.at("b").x);
  EXPECT_NE(fed.at("a").turn, fed.at("b").turn);
}

TEST_F(FeederTest, DependsOnlyOnTheSeed) {
  const auto first = run();
  EXPECT_EQ(run(), first);
  infeed().seed = 2;
  EXPECT_NE(run(), first);
}

TEST_F(FeederTest, WaitingPartKeepsItsPositionInAnother) {
  infeed().first = 1000;
  Simulation simulation(deployment_, *memory_);
  for (Tick tick = 1; tick <= 500; ++tick) simulation.step(tick);
  EXPECT_NEAR(position(simulation, "a")[2], 2, 1e-12);
  EXPECT_NEAR(position(simulation, "b")[1], 0.01, 1e-12);
}

TEST_F(FeederTest, FeedingDoesNotAllocate) {
  test::count_mujoco_allocations();
  Simulation simulation(deployment_, *memory_);
  simulation.step(1);
  const long before = test::allocations();
  for (Tick tick = 2; tick <= 600; ++tick) simulation.step(tick);
  EXPECT_EQ(test::allocations(), before);
  EXPECT_LT(position(simulation, "c")[0], 2) << "all have been fed";
}

TEST_F(FeederTest, RefusesBodiesThatAreNotFreeOrNotInTheScene) {
  infeed().parts = {"d"};
  EXPECT_EQ(refusal(), "sim.feeders.infeed.parts: the scene has no body 'd', expected a free body of it");
  infeed().parts = {"post"};
  EXPECT_EQ(refusal(), "sim.feeders.infeed.parts: body 'post' is not free, expected a <freejoint/> in it");
}

}  // namespace
}  // namespace mrroc::sim::feeder_test
