#include <gtest/gtest.h>

#include "robots/irb6/family/cases.hpp"

namespace mrroc {
namespace {

TEST(TransmissionLaw, MotorsReturnToTheirJoints) {
  EXPECT_TRUE(rc::check([] {
    const RobotModel& model = any_model();
    const JointVector joints = any_posture();
    JointVector motors, back;
    RC_ASSERT(model.joints_to_motors(joints, motors) == ErrorCode::none);
    RC_ASSERT(model.motors_to_joints(motors, back) == ErrorCode::none);
    RC_ASSERT((back - joints).cwiseAbs().maxCoeff() < 1e-10);
  }));
}

TEST(TransmissionLaw, MatrixIsTheDerivativeOfMotorsByJoints) {
  EXPECT_TRUE(rc::check([] {
    constexpr double kStep = 1e-5;
    const RobotModel& model = any_model();
    const JointVector joints = any_posture();
    const JointMatrix g = model.transmission(joints);
    for (int i = 0; i < joints.size(); ++i) {
      JointVector ahead = joints, behind = joints, motors_ahead, motors_behind;
      ahead[i] += kStep;
      behind[i] -= kStep;
      RC_ASSERT(model.joints_to_motors(ahead, motors_ahead) == ErrorCode::none);
      RC_ASSERT(model.joints_to_motors(behind, motors_behind) == ErrorCode::none);
      const JointVector slope = (motors_ahead - motors_behind) / (2 * kStep);
      RC_ASSERT((slope - g.col(i)).cwiseAbs().maxCoeff() < 1e-5);
    }
  }));
}

TEST(TransmissionLaw, InvalidInputGivesACodeOrFiniteNumbers) {
  EXPECT_TRUE(rc::check([] {
    const RobotModel& model = any_model();
    const JointVector garbage = any_garbage_joints(robot().joint_count());
    JointVector result = JointVector::Zero(garbage.size());
    const bool to_motors = model.joints_to_motors(garbage, result) == ErrorCode::none;
    RC_ASSERT(result.allFinite());
    const bool to_joints = model.motors_to_joints(garbage, result) == ErrorCode::none;
    RC_ASSERT(result.allFinite());
    RC_ASSERT(garbage.allFinite() || !(to_motors || to_joints));
    if (garbage.allFinite()) RC_ASSERT(model.transmission(garbage).allFinite());
  }));
}

}  // namespace
}  // namespace mrroc
