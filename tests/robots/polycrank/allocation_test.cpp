#include <gtest/gtest.h>

#include "robots/common/allocation_count.hpp"
#include "robots/polycrank/polycrank_fixture.hpp"

namespace mrroc {
namespace {

TEST(PolycrankAllocation, TheCounterSeesNewAndEigensHeap) {
  const long before = allocation_count();
  ::operator delete(::operator new(8));
  const long after_new = allocation_count();
  const Eigen::VectorXd heap = Eigen::VectorXd::Constant(100, static_cast<double>(before));
  EXPECT_EQ(after_new - before, 1);
  EXPECT_EQ(allocation_count() - after_new, 1) << heap[0];
}

TEST(PolycrankAllocation, NoMethodAllocates) {
  const RobotModel& model = polycrank_model();
  std::mt19937_64 random(20110117);
  std::vector<JointVector> postures;
  for (int i = 0; i < 100; ++i) postures.push_back(random_joints(random));
  JointVector motors, joints;
  double sum = 0;
  const long before = allocation_count();
  for (const JointVector& posture : postures) {
    model.inverse(model.flange(posture), model.parameters().home, joints);
    model.joints_to_motors(posture, motors);
    model.motors_to_joints(motors, joints);
    sum += model.transmission(posture).sum() + model.jacobian(posture, Eigen::Vector3d(0.1, 0.2, 0.3)).sum() +
           joints.sum() + model.default_tool().translation().sum();
  }
  EXPECT_EQ(allocation_count() - before, 0);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace mrroc
