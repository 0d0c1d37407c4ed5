#include <gtest/gtest.h>

#include "gripper_fixture.hpp"
#include "sim/mujoco_allocations.hpp"

namespace mrroc::allocation_test {
namespace {

TEST(GripperAllocation, MethodsDoNotAllocate) {
  const RobotModel& model = *gripper_model();
  JointVector motors, joints;
  double sum = 0;
  EXPECT_GT(test::allocations(), 0) << "the counter counts nothing";
  const long before = test::allocations();
  for (double opening = 0.053; opening < 0.091; opening += 0.001) {
    const JointVector posture = one(opening);
    model.inverse(model.flange(posture) * model.default_tool(), posture, joints);
    model.joints_to_motors(posture, motors);
    model.motors_to_joints(motors, joints);
    sum += model.transmission(posture).sum() + model.jacobian(posture, Eigen::Vector3d::Ones()).sum() + joints.sum();
  }
  EXPECT_EQ(test::allocations() - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace mrroc::allocation_test
