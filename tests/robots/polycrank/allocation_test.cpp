#include <gtest/gtest.h>

#include "allocations.hpp"
#include "robots/polycrank/polycrank_fixture.hpp"

namespace mrroc::allocation_test {
namespace {

TEST(PolycrankAllocation, CounterCountsNewAndEigensHeap) {
  const std::uint64_t before = test::allocations();
  ::operator delete(::operator new(8));
  const std::uint64_t after_new = test::allocations();
  const Eigen::VectorXd heap = Eigen::VectorXd::Constant(100, static_cast<double>(before));
  EXPECT_EQ(after_new - before, 1);
  EXPECT_EQ(test::allocations() - after_new, 1u) << heap[0];
}

TEST(PolycrankAllocation, MethodsDoNotAllocate) {
  const RobotModel& model = polycrank_model();
  std::mt19937_64 random(20110117);
  std::vector<JointVector> postures;
  for (int i = 0; i < 100; ++i) postures.push_back(random_joints(random));
  JointVector motors, joints;
  double sum = 0;
  const std::uint64_t before = test::allocations();
  for (const JointVector& posture : postures) {
    model.inverse(model.flange(posture), model.parameters().home, joints);
    model.joints_to_motors(posture, motors);
    model.motors_to_joints(motors, joints);
    sum += model.transmission(posture).sum() + model.jacobian(posture, Eigen::Vector3d(0.1, 0.2, 0.3)).sum() +
           joints.sum() + model.default_tool().translation().sum();
  }
  EXPECT_EQ(test::allocations() - before, 0u);
  EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace
}  // namespace mrroc::allocation_test
