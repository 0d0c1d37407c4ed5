#include "edp/check/urdf_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "config/message_of.hpp"
#include "edp/every_robot.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/common/changed_file.hpp"

namespace mrroc::edp::urdf_check_test {
namespace {

/// The errors in the URDF of a robot when the first `from` in it is replaced by `to`.
std::string mistake(const std::string& type, const std::string& from, const std::string& to) {
  const auto robots = every_robot();
  const auto robot = std::find_if(robots.begin(), robots.end(), [&type](const auto& r) { return r.type == type; });
  const task_test::ScratchFolder scratch;
  const auto file = scratch.write("r.urdf", changed_file(robot->file("urdf"), from, to));
  const auto models = robot->load(robot->file("toml"));
  return config::message_of(scratch.path(), [&] { check_urdf(*models.front(), file); });
}

testing::AssertionResult has(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    if (message.find(part) == std::string::npos) {
      return testing::AssertionFailure() << "\"" << message << "\" has no \"" << part << "\"";
    }
  }
  return testing::AssertionSuccess();
}

TEST(UrdfCheck, RefusesAWrongLengthWithBothPositionsAndThePosture) {
  const std::string message = mistake("irb6", "xyz=\"0.67 0 0\"", "xyz=\"0.6702 0 0\"");
  EXPECT_TRUE(has(message, {"r.urdf:", ": link 'flange': is at (", " m, the model has it at (", ", 0.0002 m and ",
                            " rad apart, at joints (0, -1.74778, 0.476819, -0.299834, 4.71239, 1.5708)",
                            ", expected at most 1e-06"}));
  EXPECT_TRUE(has(mistake("polycrank", "xyz=\"0.152 0.18 0\"", "xyz=\"0.152 0.181 0\""), {"link 'flange'"}));
  EXPECT_TRUE(has(mistake("irb6_track", "xyz=\"0.455 0 0\" rpy=\"0 1.57", "xyz=\"0.455002 0 0\" rpy=\"0 1.57"),
                  {"link 'flange'", "2e-06 m"}));
}

TEST(UrdfCheck, RefusesAToolThatIsNotTheDefaultOne) {
  EXPECT_TRUE(has(mistake("irb6", "xyz=\"0 0 0.16\"", "xyz=\"0 0 0.15\""), {"link 'tool_frame'", "0.01 m and "}));
  EXPECT_TRUE(has(mistake("two_finger_gripper", "xyz=\"0 0 0.125\"", "xyz=\"0 0 0.126\""), {"link 'tool_frame'"}));
  EXPECT_TRUE(has(mistake("conveyor", "xyz=\"1 0 0\"", "xyz=\"1 0.001 0\""), {"link 'tool_frame'"}));
}

TEST(UrdfCheck, RefusesAnAxisWithTheWrongDirection) {
  EXPECT_TRUE(
      has(mistake("irb60", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 -1\"/>"), {"link 'flange'", " rad apart"}));
  EXPECT_TRUE(
      has(mistake("irb6_five_axis", "<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 1 0.001\"/>"), {"link 'tool_frame'"}));
}

TEST(UrdfCheck, RefusesAJointThatIsMissingOrCannotMove) {
  EXPECT_EQ(mistake("irb6", "<joint name=\"tool_roll\"", "<joint name=\"roll\""),
            "r.urdf: no joint 'tool_roll', expected one for every axis");
  EXPECT_TRUE(
      has(mistake("irb6", "<joint name=\"tool_roll\" type=\"revolute\"", "<joint name=\"tool_roll\" type=\"fixed\""),
          {"r.urdf:", "joint 'tool_roll': is fixed, expected a joint that moves"}));
}

TEST(UrdfCheck, RefusesLimitsThatDisagree) {
  EXPECT_TRUE(has(mistake("irb6", "lower=\"-2.94\"", "lower=\"-2.95\""),
                  {"joint 'column': lower -2.95, expected the axis's -2.94"}));
  EXPECT_TRUE(has(mistake("irb6", "upper=\"2.93\"", ""), {"joint 'tool_roll': upper 0, expected the axis's 2.93"}));
  EXPECT_TRUE(has(mistake("irb6", "velocity=\"0.43\"", "velocity=\"0.44\""),
                  {"joint 'tool_roll': velocity 0.44, expected the axis's velocity_max 0.43"}));
  EXPECT_TRUE(
      has(mistake("irb6", "<joint name=\"column\" type=\"revolute\"", "<joint name=\"column\" type=\"continuous\""),
          {"joint 'column': is continuous, without lower limit, expected the axis's -2.94"}));
  EXPECT_TRUE(has(mistake("conveyor", "upper=\"1e9\"", "upper=\"1000\""),
                  {"joint 'belt': upper 1000, expected the axis's inf"}));
  EXPECT_TRUE(has(mistake("conveyor", "lower=\"-1e9\"", "lower=\"1e9\""),
                  {"joint 'belt': lower 1e+09, expected the axis's -inf"}));
}

TEST(UrdfCheck, RefusesAFingerThatDoesNotFollow) {
  EXPECT_TRUE(has(mistake("two_finger_gripper", "multiplier=\"0.5\"", "multiplier=\"0.4\""), {"link 'tool_frame'"}));
  EXPECT_TRUE(has(mistake("two_finger_gripper", "<mimic joint=\"opening\" multiplier=\"0.5\" offset=\"0\"/>", ""),
                  {"joint 'centring': its position is not determined"}));
}

TEST(UrdfCheck, RefusesLoopsThatDoNotClose) {
  EXPECT_EQ(mistake("serial_parallel", "xyz=\"0 -0.05 0\"", "xyz=\"0 -0.05 0.0\""), "");
  EXPECT_TRUE(has(mistake("serial_parallel", "xyz=\"0 -0.05 0\"", "xyz=\"0 -0.051 0\""), {"link 'flange'", "0.001 m"}));
  EXPECT_TRUE(
      has(mistake("serial_parallel", "xyz=\"0.18 0 0\"", "xyz=\"0.181 0 0\""),
          {"link 'head_b': is at (", "link 'joint_b', to which it is joined, at (", "0.001 m apart, at joints ("}));
  EXPECT_TRUE(has(mistake("serial_parallel", "xyz=\"0.086 0 0\"", "xyz=\"0.087 0 0\""), {"link 'head_b'"}));
  EXPECT_TRUE(has(mistake("serial_parallel", "<joint name=\"lean_a\"", "<joint name=\"lean\""),
                  {"joint 'lean': its position is not determined"}));
}

TEST(UrdfCheck, RefusesAUrdfWithNothingToCompare) {
  const task_test::ScratchFolder scratch;
  std::string text =
      changed_file(every_robot().front().file("urdf"), "<link name=\"tool_frame\"/>", "<link name=\"mark\"/>");
  const std::string child = "<child link=\"tool_frame\"/>";
  text.replace(text.find(child), child.size(), "<child link=\"mark\"/>");
  const auto file = scratch.write("r.urdf", text);
  const auto models = every_robot().front().load(every_robot().front().file("toml"));
  EXPECT_EQ(config::message_of(scratch.path(), [&] { check_urdf(*models.front(), file); }),
            "r.urdf: no link to compare with the model, expected a link 'flange' or 'tool_frame'");
}

}  // namespace
}  // namespace mrroc::edp::urdf_check_test
