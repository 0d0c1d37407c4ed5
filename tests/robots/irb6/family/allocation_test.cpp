#include <gtest/gtest.h>

#include "robots/common/allocation_count.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

TEST(Allocation, TheCounterSeesNewAndEigensHeap) {
  const long before = allocation_count();
  ::operator delete(::operator new(8));
  const long after_new = allocation_count();
  const Eigen::VectorXd heap = Eigen::VectorXd::Constant(100, static_cast<double>(before));
  EXPECT_EQ(after_new - before, 1);
  EXPECT_EQ(allocation_count() - after_new, 1) << heap[0];
}

TEST(Allocation, NoMethodAllocates) {
  std::mt19937_64 random(20060103);
  std::vector<JointVector> postures;
  for (int i = 0; i < 100; ++i) postures.push_back(random_posture(random));
  JointVector motors, joints;
  double sum = 0;
  const long before = allocation_count();
  for (const auto& model : robot_under_test().models) {
    const ToolKinematics kinematics(*model);
    for (const JointVector& posture : postures) {
      const Pose pose = kinematics.direct(posture);
      kinematics.inverse(pose, model->parameters().home, joints);
      model->joints_to_motors(posture, motors);
      model->motors_to_joints(motors, joints);
      sum += model->transmission(posture).sum() + kinematics.jacobian(posture).sum() + joints.sum();
    }
  }
  EXPECT_EQ(allocation_count() - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace mrroc
