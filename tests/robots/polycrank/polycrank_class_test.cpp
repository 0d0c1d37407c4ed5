#include <gtest/gtest.h>

#include "mrroc/robots/polycrank.hpp"
#include "robots/common/one_robot_task.hpp"
#include "robots/polycrank/polycrank_fixture.hpp"

namespace mrroc::polycrank_class_test {
namespace {

TEST(PolycrankClass, UsesItsProcessesRobotAndTheInstalledModel) {
  OneRobotTask process("arm", "polycrank");
  Polycrank arm(process);
  EXPECT_EQ(arm.name(), "arm");
  EXPECT_EQ(arm.parameters().type, "polycrank");
  const JointVector home = arm.parameters().home;
  EXPECT_EQ(arm.kinematics().direct(home).matrix(), ToolKinematics(polycrank_model()).direct(home).matrix());
  process.state.joints = home;
  arm.command().joints = home;
  arm.send();
  arm.receive();
  EXPECT_EQ(process.sent.joints, home);
  EXPECT_EQ(arm.state().joints, home);
}

TEST(PolycrankClass, RefusesANameThatIsNotInTheDeployment) {
  OneRobotTask process("arm", "polycrank");
  EXPECT_THROW(Polycrank(process, "leg"), NonFatalError);
}

}  // namespace
}  // namespace mrroc::polycrank_class_test
