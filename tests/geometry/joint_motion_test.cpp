#include "geometry/joint_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cstdio>

#include "allocations.hpp"
#include "kinematics/chain_model.hpp"
#include "kinematics/chains.hpp"

namespace mrroc {
namespace {

using kinematics::test::panda;
using kinematics::test::puma560;
using kinematics::test::random_chain;
using kinematics::test::random_joints;
using kinematics::test::random_vector;
using kinematics::test::ur5e;

kinematics::ChainModel model_of(const kinematics::SerialChain& chain) {
  RobotParameters parameters;
  parameters.axes.resize(static_cast<std::size_t>(chain.size()));
  for (AxisParameters& axis : parameters.axes) axis.position_max = 3;
  return {"nominal", parameters, chain, JointVector::Ones(chain.size())};
}

/// At any rank of the Jacobian: seven axes, six, fewer, aligned ones. Bit for bit what Eigen's own solution is.
TEST(JointMotion, VelocityOfATwistAllocatesNothing) {
  std::mt19937_64 random(1);
  std::printf("seed 1\n");
  for (const kinematics::SerialChain& chain :
       {panda(), puma560(), ur5e(), random_chain(random, 8, true), random_chain(random, 4, false)}) {
    const kinematics::ChainModel model = model_of(chain);
    const ToolKinematics kinematics(model);
    for (int round = 0; round < 300; ++round) {
      JointVector joints = random_joints(random, chain.size());
      if (round % 3 == 0) joints.tail(chain.size() - 2).setZero();  // aligned wrists, stretched arms
      Twist twist;
      twist << random_vector(random), random_vector(random);
      const JointVector expected =
          Eigen::CompleteOrthogonalDecomposition<Jacobian>(kinematics.jacobian(joints)).solve(twist);
      JointVector velocity;
      {
        const test::Counting counting;
        velocity = joint_velocity_of(kinematics, joints, twist);
      }
      ASSERT_EQ(test::Counting::counted(), 0U) << chain.size() << " axes, round " << round;
      ASSERT_EQ(velocity, expected) << chain.size() << " axes, round " << round;
    }
  }
}

}  // namespace
}  // namespace mrroc
