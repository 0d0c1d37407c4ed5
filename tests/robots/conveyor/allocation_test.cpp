#include <gtest/gtest.h>

#include "robots/conveyor/conveyor_fixture.hpp"
#include "sim/mujoco_allocations.hpp"

namespace mrroc {
namespace {

TEST(ConveyorAllocation, MethodsDoNotAllocate) {
  const RobotModel& model = *conveyor_model();
  JointVector motors, joints;
  double sum = 0;
  EXPECT_GT(test::allocations(), 0) << "the counter counts nothing";
  const long before = test::allocations();
  for (double travel = -1; travel < 1; travel += 0.01) {
    const JointVector posture = one(travel);
    model.inverse(model.flange(posture) * model.default_tool(), posture, joints);
    model.joints_to_motors(posture, motors);
    model.motors_to_joints(motors, joints);
    sum += model.transmission(posture).sum() + model.jacobian(posture, Eigen::Vector3d::Ones()).sum() + joints.sum();
  }
  EXPECT_EQ(test::allocations() - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace mrroc
