#include <gtest/gtest.h>

#include "fixture.hpp"
#include "robots/common/allocation_count.hpp"

namespace mrroc {
namespace {

TEST(SerialParallelAllocation, TheCounterSeesNewAndEigensHeap) {
  const long before = allocation_count();
  ::operator delete(::operator new(8));
  const long after_new = allocation_count();
  const Eigen::VectorXd heap = Eigen::VectorXd::Constant(100, static_cast<double>(before));
  EXPECT_EQ(after_new - before, 1);
  EXPECT_EQ(allocation_count() - after_new, 1) << heap[0];
}

TEST(SerialParallelAllocation, NoMethodAllocates) {
  const RobotModel& model = machine();
  std::mt19937_64 random(20060103);
  std::vector<JointVector> postures;
  for (int i = 0; i < 100; ++i) postures.push_back(random_posture(random));
  postures.push_back(JointVector::Zero(6));  // legs that do not close
  JointVector motors, joints = model.parameters().home;
  double sum = 0;
  const long before = allocation_count();
  for (const JointVector& posture : postures) {
    const Pose pose = model.flange(posture);
    model.inverse(pose, model.parameters().home, joints);
    model.joints_to_motors(joints, motors);
    model.motors_to_joints(motors, joints);
    sum += model.transmission(posture).sum() + model.jacobian(posture, {0, 0, 0.1}).sum() + joints.sum();
  }
  EXPECT_EQ(allocation_count() - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace mrroc
