#pragma once

#include <string>
#include <utility>
#include <vector>

#include "config/deployment.hpp"
#include "config/message_of.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "sim/scene/compose.hpp"
#include "sim/scene/model.hpp"
#include "world/world_memory.hpp"

namespace mrroc::sim {

inline const std::filesystem::path kData = std::filesystem::path(MRROC_SOURCE_DIR) / "tests/sim/data";
inline const std::filesystem::path kTwolink = kData / "robots/twolink/twolink.xml";

/// A scene that adds no computation to that of the robots.
inline constexpr const char* kEmptyScene = "<mujoco>\n<compiler angle='radian'/>\n</mujoco>";

inline Pose at(double x, double y, double z, double turn = 0) {
  return Eigen::Translation3d(x, y, z) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * Pose::Identity();
}

/// Composes a scene of text with robots given as (name, MJCF text), each at the origin.
inline Composition compose_texts(const task_test::ScratchFolder& scratch, const std::string& scene,
                                 const std::vector<std::pair<std::string, std::string>>& robots = {}) {
  std::vector<RobotPart> parts;
  for (const auto& [name, text] : robots) {
    parts.push_back({name, scratch.write("robots/" + name + ".xml", text), Pose::Identity(), false});
  }
  return compose(scratch.write("scene.xml", scene), parts);
}

/// A deployment with the test scene, a force/torque sensor and a range finder, and `count` two-link arms a0, a1, ...
inline config::Deployment twolink_deployment(std::size_t count) {
  config::Deployment deployment;
  deployment.file = kData / "test.toml";
  deployment.sim.emplace();
  deployment.sim->scene = kData / "scene.xml";
  for (std::size_t i = 0; i < count; ++i) {
    config::RobotEntry robot;
    robot.name = "a" + std::to_string(i);
    robot.type = "twolink";
    robot.driver.world = true;
    robot.base = at(1.2 * static_cast<double>(i), 0, 0.5, 0.3 * static_cast<double>(i));
    deployment.robots.push_back(robot);
  }
  config::SensorEntry gate;
  gate.name = "gate";
  gate.type = "ultrasonic";
  deployment.sensors.push_back(gate);
  config::SensorEntry wrist;
  wrist.name = "wrist";
  wrist.type = "force_torque";
  wrist.robot = "a0";
  deployment.sensors.push_back(wrist);
  return deployment;
}

}  // namespace mrroc::sim
