#include <gtest/gtest.h>

#include <Eigen/LU>
#include <iostream>

#include "robots/common/mjcf.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

// the machine's rated load: 60 kg at the default tool frame, in every posture, with a current reserve for motion
TEST(Irb60Payload, DrivesHoldSixtyKilograms) {
  constexpr double kPayload = 60, kGravity = 9.81;
  std::mt19937_64 random(20060110);
  Mjcf mjcf(robot_file("xml"));
  JointVector worst = JointVector::Zero(6);
  for (int i = 0; i < 3000; ++i) {
    const JointVector posture = random_posture(random);
    mjcf.set_joints(posture);
    mj_forward(mjcf.model.get(), mjcf.data.get());
    const JointVector bias = Eigen::Map<const Eigen::VectorXd>(mjcf.data->qfrc_bias, 6);
    const JointVector load = arm().jacobian(posture).row(2).transpose() * kPayload * kGravity;
    const JointMatrix g = robot().transmission(posture);
    const JointVector torque = JointMatrix(g.transpose()).partialPivLu().solve(JointVector(bias + load));
    worst = worst.cwiseMax(torque.cwiseQuotient(per_axis(&AxisParameters::torque_constant)).cwiseAbs());
  }
  std::cout << "worst of 3000 postures, A: " << worst.transpose() << "\n";
  EXPECT_LT(worst.cwiseQuotient(per_axis(&AxisParameters::current_max)).maxCoeff(), 0.5);
  EXPECT_GT(worst.maxCoeff(), 3) << "a load with an effect on the drives";
}

}  // namespace
}  // namespace mrroc
