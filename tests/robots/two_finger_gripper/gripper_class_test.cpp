#include <gtest/gtest.h>

#include <cmath>

#include "mrroc/robots/two_finger_gripper.hpp"
#include "robots/common/one_robot_task.hpp"

namespace mrroc::gripper_class_test {
namespace {

class GripperClass : public testing::Test {
 protected:
  /// The gripper's state: fingers at `opening` moving with `velocity`, to be at `desired` four ticks later.
  void know(double opening, double velocity, double desired) {
    process.state.tick = 100;
    process.state.joints = TwoFingerGripper::at(opening);
    process.state.joint_velocity = TwoFingerGripper::at(velocity);
    process.state.desired_tick = 104;
    process.state.desired_joints = TwoFingerGripper::at(desired);
    gripper.send();
    gripper.receive();
  }
  bool gripped() { return Gripped{gripper}.evaluate(); }

  OneRobotTask process{"gripper", "two_finger_gripper"};
  TwoFingerGripper gripper{process};
};

TEST_F(GripperClass, UsesItsProcessesRobotAndTheInstalledModel) {
  EXPECT_EQ(gripper.name(), "gripper");
  EXPECT_EQ(gripper.parameters().type, "two_finger_gripper");
  EXPECT_EQ(gripper.grip_centre().translation(), Eigen::Vector3d(0, 0, 0.125));
  EXPECT_THROW(TwoFingerGripper(process, "hand"), NonFatalError);
}

TEST_F(GripperClass, NothingIsGrippedBeforeTheFirstState) {
  EXPECT_TRUE(std::isnan(gripper.held_open()));
  EXPECT_FALSE(gripped());
}

TEST_F(GripperClass, FingersWithoutAFollowingErrorGripNothing) {
  know(0.07, 0, 0.07);
  EXPECT_FALSE(gripped());
  know(0.07, -0.006, 0.07 - 0.006 * 4 * 0.002);
  EXPECT_NEAR(gripper.held_open(), 0, 1e-15);
  know(0.0702, 0, 0.07);
  EXPECT_FALSE(gripped()) << "0.2 mm is the servo's";
}

TEST_F(GripperClass, FingersWiderThanDesiredGrip) {
  know(0.057, 0, 0.0564);
  EXPECT_NEAR(gripper.held_open(), 0.0006, 1e-15);
  EXPECT_TRUE(gripped());
  know(0.0564, 0, 0.057);
  EXPECT_FALSE(gripped()) << "held shut";
}

}  // namespace
}  // namespace mrroc::gripper_class_test
