#include <gtest/gtest.h>

#include "allocations.hpp"
#include "fixture.hpp"

namespace mrroc::allocation_test {
namespace {

TEST(SerialParallelAllocation, CounterCountsNewAndEigensHeap) {
  const std::uint64_t before = test::allocations();
  ::operator delete(::operator new(8));
  const std::uint64_t after_new = test::allocations();
  const Eigen::VectorXd heap = Eigen::VectorXd::Constant(100, static_cast<double>(before));
  EXPECT_EQ(after_new - before, 1);
  EXPECT_EQ(test::allocations() - after_new, 1u) << heap[0];
}

TEST(SerialParallelAllocation, MethodsDoNotAllocate) {
  const RobotModel& model = machine();
  std::mt19937_64 random(20060103);
  std::vector<JointVector> postures;
  for (int i = 0; i < 100; ++i) postures.push_back(random_posture(random));
  postures.push_back(JointVector::Zero(6));  // legs that do not close
  JointVector motors, joints = model.parameters().home;
  double sum = 0;
  const std::uint64_t before = test::allocations();
  for (const JointVector& posture : postures) {
    const Pose pose = model.flange(posture);
    model.inverse(pose, model.parameters().home, joints);
    model.joints_to_motors(joints, motors);
    model.motors_to_joints(motors, joints);
    sum += model.transmission(posture).sum() + model.jacobian(posture, {0, 0, 0.1}).sum() + joints.sum();
  }
  EXPECT_EQ(test::allocations() - before, 0u);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace mrroc::allocation_test
