#pragma once

#include <gtest/gtest.h>

#include "robots/common/simulated_edp.hpp"
#include "robots/conveyor/conveyor_fixture.hpp"

namespace mrroc {

/// The belt of the demo with an encoder, in the demo's scene, without its task program.
inline config::Deployment demo() {
  config::Deployment deployment;
  deployment.sim.emplace();
  deployment.sim->scene = conveyor_source("demo.xml");
  config::RobotEntry robot;
  robot.name = "belt";
  robot.type = "conveyor";
  robot.parameters = conveyor_file("toml");
  robot.driver.world = true;
  robot.base.translation().z() = 0.55;
  deployment.robots.push_back(robot);
  config::SensorEntry encoder;
  encoder.name = "encoder";
  encoder.type = "conveyor_encoder";
  encoder.robot = "belt";
  deployment.sensors.push_back(encoder);
  return deployment;
}

/// Three parts on the belt, which the EDP core of the conveyor under test drives.
class ConveyorCarries : public testing::Test {
 protected:
  ConveyorCarries() {
    simulation_.publish_initial();
    edp_.start();
    run(100);  // the parts settle
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      simulation_.step(++now_);
      edp_.tick(now_);
    }
  }
  /// x of the parts, m.
  Eigen::Vector3d parts() {
    const sim::World& world = simulation_.world();
    const auto x = [&](const char* name) {
      return world.data().xpos[3 * mj_name2id(&world.model(), mjOBJ_BODY, name)];
    };
    return {x("block"), x("disc"), x("bar")};
  }
  /// Largest distance of a part from its position after `way` of the belt.
  double slip(const Eigen::Vector3d& before, double way) {
    return (parts() - before - Eigen::Vector3d::Constant(way)).cwiseAbs().maxCoeff();
  }
  RawReading encoder() const {
    RawReading reading;
    EXPECT_TRUE(memory_->readings[0].load(reading));
    return reading;
  }
  double travel() const { return edp_.snapshot().joints[0]; }

  std::unique_ptr<world::WorldMemory> memory_ = std::make_unique<world::WorldMemory>();
  sim::Simulation simulation_{demo(), *memory_};
  SimulatedEdp edp_{conveyor_model(), *memory_, 0};
  Tick now_ = 0;
};

}  // namespace mrroc
