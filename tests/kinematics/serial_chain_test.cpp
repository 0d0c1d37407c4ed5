#include "kinematics/serial_chain.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <stdexcept>

#include "kinematics/chains.hpp"
#include "kinematics/newton.hpp"

namespace mrroc::kinematics {
namespace {

using namespace test;

class SerialChainTest : public testing::Test {
 protected:
  SerialChainTest() { std::printf("seed 1\n"); }
  std::mt19937_64 random{1};
};

/// The product of the frames and motions one by one, with the axes as they are given.
TEST_F(SerialChainTest, FlangeIsTheProductOfItsJoints) {
  for (int round = 0; round < 500; ++round) {
    const int count = 1 + static_cast<int>(random() % kMaxJoints);
    std::vector<ChainJoint> joints;
    for (int i = 0; i < count; ++i)
      joints.push_back({random_pose(random), random_vector(random).normalized(), random() % 3 == 0});
    const Pose end = random_pose(random);
    const SerialChain chain(joints, end);
    const JointVector q = random_joints(random, count);
    Pose product = Pose::Identity();
    SerialChain::Axes axes;
    chain.compute(q, axes);
    for (int i = 0; i < count; ++i) {
      const ChainJoint& joint = joints[static_cast<std::size_t>(i)];
      product = product * joint.frame;
      ASSERT_LT((axes.origin[static_cast<std::size_t>(i)] - product.translation()).norm(), 1e-12);
      ASSERT_LT((axes.axis[static_cast<std::size_t>(i)] - product.linear() * joint.axis).norm(), 1e-12);
      product = joint.slides ? product * Eigen::Translation3d(q[i] * joint.axis)
                             : product * Eigen::AngleAxisd(q[i], joint.axis);
    }
    product = product * end;
    ASSERT_LT((chain.flange(q).matrix() - product.matrix()).norm(), 1e-12);
    ASSERT_LT((axes.flange.matrix() - product.matrix()).norm(), 1e-12);
  }
}

TEST_F(SerialChainTest, JacobianIsTheDerivativeOfTheFlange) {
  constexpr double kStep = 1e-6;
  for (int round = 0; round < 200; ++round) {
    const int count = 1 + static_cast<int>(random() % kMaxJoints);
    const SerialChain chain = random_chain(random, count, true);
    const JointVector q = random_joints(random, count);
    const Eigen::Vector3d offset = random_vector(random);
    const Jacobian jacobian = chain.jacobian(q, offset);
    for (int i = 0; i < count; ++i) {
      JointVector less = q, more = q;
      less[i] -= kStep;
      more[i] += kStep;
      const Pose point{Eigen::Translation3d(offset)};
      const Twist twist = displacement(chain.flange(less) * point, chain.flange(more) * point) / (2 * kStep);
      ASSERT_LT((jacobian.col(i) - twist).norm(), 1e-7) << "joint " << i;
    }
  }
}

TEST(SerialChain, RefusesWhatIsNoChain) {
  const ChainJoint good;
  ChainJoint no_axis, sheared;
  no_axis.axis = Eigen::Vector3d(1, 1, 0);
  sheared.frame.linear()(0, 1) = 0.1;
  EXPECT_THROW(SerialChain({}, Pose::Identity()), std::invalid_argument);
  EXPECT_THROW(SerialChain(std::vector<ChainJoint>(kMaxJoints + 1), Pose::Identity()), std::invalid_argument);
  EXPECT_THROW(SerialChain({no_axis}, Pose::Identity()), std::invalid_argument);
  EXPECT_THROW(SerialChain({sheared}, Pose::Identity()), std::invalid_argument);
  EXPECT_THROW(SerialChain({good}, sheared.frame), std::invalid_argument);
  EXPECT_NO_THROW(SerialChain({good}, Pose::Identity()));
}

}  // namespace
}  // namespace mrroc::kinematics
