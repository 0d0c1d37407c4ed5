#include <gtest/gtest.h>

#include "mrroc/robots/irb6_five_axis.hpp"
#include "robots/common/one_robot_task.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

TEST(Irb6FiveAxisClass, UsesItsProcessesRobotAndTheInstalledModels) {
  OneRobotTask process("arm", "irb6_five_axis");
  Irb6FiveAxis robot(process);
  EXPECT_EQ(robot.name(), "arm");
  EXPECT_EQ(robot.parameters().type, "irb6_five_axis");
  ASSERT_EQ(robot.models().size(), robot_under_test().models.size());
  const JointVector home = robot.parameters().home;
  EXPECT_EQ(robot.kinematics().direct(home).matrix(), arm().direct(home).matrix());
  process.state.joints = home;
  robot.command().joints = home;
  robot.send();
  robot.receive();
  EXPECT_EQ(process.sent.joints, home);
  EXPECT_EQ(robot.state().joints, home);
}

TEST(Irb6FiveAxisClass, RefusesANameThatIsNotInTheDeployment) {
  OneRobotTask process("arm", "irb6_five_axis");
  EXPECT_THROW(Irb6FiveAxis(process, "leg"), NonFatalError);
}

TEST(Irb6FiveAxisClass, ToolDownPointsTheToolDown) {
  const Pose pose = Irb6FiveAxis::tool_down(1, 2, 3);
  EXPECT_EQ(pose.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(pose.linear(), Eigen::Matrix3d(Eigen::Vector3d(1, -1, -1).asDiagonal()));
}

}  // namespace
}  // namespace mrroc
