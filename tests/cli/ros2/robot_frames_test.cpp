#include "cli/ros2/robot_frames.hpp"

#include <gtest/gtest.h>

#include <map>

#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::robot_frames_test {
namespace {

using Transform = messages::geometry_msgs::TransformStamped;

std::map<std::string, Transform> by_child(const RobotFrames::Transforms& transforms) {
  std::map<std::string, Transform> found;
  for (const Transform& each : transforms) EXPECT_TRUE(found.emplace(each.child_frame_id, each).second);
  return found;
}

config::RobotEntry installed(const std::string& type) {
  config::RobotEntry robot;
  robot.name = "arm";
  robot.type = type;
  return robot;
}

RobotFrames::Transforms moving(const RobotFrames& frames, const std::vector<double>& joints,
                               const Pose& tool = Pose::Identity(), const Pose& tool_in_flange = Pose::Identity()) {
  RobotFrames::Transforms transforms;
  frames.append({}, joints, tool, tool_in_flange, transforms);
  return transforms;
}

TEST(RobotFrames, EveryLinkHasOneParent) {
  for (const char* type : {"irb6", "irb6_five_axis", "irb6_track", "irb60", "polycrank", "conveyor"}) {
    const RobotFrames frames(installed(type), "left/", "world");
    RobotFrames::Transforms all = frames.fixed();
    const auto rest = moving(frames, std::vector<double>(frames.joints().size(), 0.1));
    all.insert(all.end(), rest.begin(), rest.end());
    const auto found = by_child(all);
    const auto urdf = edp::Urdf::load(installed(type).files().urdf);
    for (const std::string& link : urdf.links()) EXPECT_TRUE(found.contains("left/" + link)) << type << " " << link;
    EXPECT_EQ(found.at(frames.tool()).header.frame_id, frames.base()) << type;
  }
}

TEST(RobotFrames, AJointsTransformIsItsOriginAndItsMotion) {
  config::RobotEntry robot = installed("irb6");
  robot.base.translation() = Eigen::Vector3d(1, 2, 3);
  const RobotFrames frames(robot, "", "world");
  EXPECT_EQ(by_child(frames.fixed()).at("base").transform.translation.y, 2);
  const auto column = by_child(moving(frames, {M_PI / 2, 0, 0, 0, 0, 0})).at("column");
  EXPECT_EQ(column.header.frame_id, "base");
  EXPECT_NEAR(column.transform.rotation.z, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(column.transform.rotation.w, std::sqrt(0.5), 1e-12);
}

TEST(RobotFrames, FlangeIsTheToolWithoutItsFrame) {
  const RobotFrames frames(installed("irb6"), "left/", "world");
  Pose tool = Pose::Identity(), in_flange = Pose::Identity();
  tool.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  tool.translation() = Eigen::Vector3d(0.8, 0, 0.5);
  in_flange.translation() = Eigen::Vector3d(0, 0, 0.2);
  const auto found = by_child(moving(frames, std::vector<double>(6, 0.0), tool, in_flange));
  EXPECT_EQ(found.at("left/arm_flange").header.frame_id, frames.base());
  EXPECT_NEAR(found.at("left/arm_flange").transform.translation.z, 0.7, 1e-12);
  EXPECT_NEAR(found.at("left/arm_tool").transform.translation.z, 0.5, 1e-12);
}

TEST(RobotFrames, MeshesOfTheDescriptionAreFilesOfThisMachine) {
  const task_test::ScratchFolder folder;
  const auto parameters = folder.path() / "irb6.toml";
  std::filesystem::copy_file(installed("irb6").files().parameters, parameters);
  folder.write(
      "irb6.urdf",
      "<robot name='irb6'><link name='base'><visual><geometry><mesh filename='meshes/../a.stl'/></geometry>"
      "</visual><collision><geometry><mesh filename='package://p/b.stl'/></geometry></collision></link></robot>");
  config::RobotEntry robot = installed("irb6");
  robot.parameters = parameters;
  const RobotFrames frames(robot, "", "world");
  EXPECT_NE(frames.description().find("\"file://" + (folder.path() / "a.stl").string() + "\""), std::string::npos)
      << frames.description();
  EXPECT_NE(frames.description().find("package://p/b.stl"), std::string::npos);
}

}  // namespace
}  // namespace mrroc::cli::robot_frames_test
