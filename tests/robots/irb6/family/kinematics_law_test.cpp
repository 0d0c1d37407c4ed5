#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "robots/irb6/family/cases.hpp"

namespace mrroc {
namespace {

bool nearly_singular(const RobotModel& model, const JointVector& joints) {
  const Jacobian jacobian = model.jacobian(joints, Eigen::Vector3d::Zero());
  return Eigen::JacobiSVD<Jacobian>(jacobian).singularValues().minCoeff() < 1e-6;
}

TEST(KinematicsLaw, InverseOfTheFlangePoseIsAFixedPoint) {
  EXPECT_TRUE(rc::check([] {
    const RobotModel& model = any_model();
    const JointVector joints = any_posture();
    RC_PRE(!nearly_singular(model, joints));
    JointVector back;
    RC_ASSERT(model.inverse(model.flange(joints), joints, back) == ErrorCode::none);
    RC_ASSERT((back - joints).cwiseAbs().maxCoeff() < 1e-9);
  }));
}

TEST(KinematicsLaw, SolutionOfTheInverseFromAnyStartHasThePose) {
  EXPECT_TRUE(rc::check([] {
    const RobotModel& model = any_model();
    const Pose pose = model.flange(any_posture());
    JointVector found;
    const ErrorCode code = model.inverse(pose, any_posture(), found);
    RC_TAG(code != ErrorCode::out_of_workspace);
    if (code != ErrorCode::out_of_workspace) RC_ASSERT(pose_difference(model.flange(found), pose) < 1e-9);
  }));
}

TEST(KinematicsLaw, JacobianIsTheDerivativeOfThePose) {
  EXPECT_TRUE(rc::check([] {
    constexpr double kStep = 1e-6;
    const ToolKinematics kinematics(any_model());
    const JointVector joints = any_posture();
    const Jacobian jacobian = kinematics.jacobian(joints);
    RC_ASSERT(jacobian.cols() == joints.size());
    for (int i = 0; i < joints.size(); ++i) {
      JointVector ahead = joints, behind = joints;
      ahead[i] += kStep;
      behind[i] -= kStep;
      const Pose a = kinematics.direct(ahead), b = kinematics.direct(behind);
      const Eigen::Matrix3d spin = a.linear() * b.linear().transpose() / (2 * kStep);
      Twist twist;
      twist << (a.translation() - b.translation()) / (2 * kStep), (spin(2, 1) - spin(1, 2)) / 2,
          (spin(0, 2) - spin(2, 0)) / 2, (spin(1, 0) - spin(0, 1)) / 2;
      RC_ASSERT((twist - jacobian.col(i)).cwiseAbs().maxCoeff() < 1e-8);
    }
  }));
}

// a twist in an EDP must not move the joint that the inverse keeps, otherwise positions and velocities of one path
// contradict each other
TEST(KinematicsLaw, InverseFollowsATwistWithTheKeptJointAtRest) {
  EXPECT_TRUE(rc::check([] {
    constexpr double kStep = 1e-6;
    const RobotModel& model = any_model();
    const JointVector joints = any_posture();
    Jacobian jacobian = model.jacobian(joints, Eigen::Vector3d::Zero());
    const int kept = model.kept_joint();
    if (kept >= 0) jacobian.col(kept).setZero();
    const Eigen::JacobiSVD<Jacobian> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
    RC_PRE(svd.singularValues()[std::min<Eigen::Index>(6, joints.size()) - 1] > 0.02);
    JointVector speed = JointVector::Zero(joints.size());
    for (int i = 0; i < speed.size(); ++i) speed[i] = i == kept ? 0 : any_between(-1, 1);
    const Twist twist = jacobian * speed;
    Pose pose = model.flange(joints);
    pose.translation() += kStep * twist.head<3>();
    const Eigen::Vector3d turn = kStep * twist.tail<3>();
    pose.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.linear();
    JointVector found;
    // five axes follow a permitted twist only to first order
    if (model.inverse(pose, joints, found) != ErrorCode::none) RC_DISCARD("left the workspace");
    RC_ASSERT(((found - joints) / kStep - JointVector(svd.solve(twist))).cwiseAbs().maxCoeff() < 2e-2);
  }));
}

TEST(KinematicsLaw, InvalidInputGivesACodeOrFiniteNumbers) {
  EXPECT_TRUE(rc::check([] {
    const ToolKinematics kinematics(any_model());
    Pose pose = Pose::Identity();
    const bool keep_rotation = *rc::gen::arbitrary<bool>();
    for (int row = 0; row < 3; ++row) {
      for (int column = keep_rotation ? 3 : 0; column < 4; ++column) pose.matrix()(row, column) = any_garbage();
    }
    const JointVector near = any_garbage_joints(robot().joint_count());
    JointVector joints = JointVector::Zero(near.size());
    const ErrorCode code = kinematics.inverse(pose, near, joints);
    RC_ASSERT(joints.allFinite());
    RC_ASSERT(code == ErrorCode::out_of_workspace || (near.allFinite() && pose.matrix().allFinite()));
    if (near.allFinite()) {
      RC_ASSERT(kinematics.direct(near).matrix().allFinite());
      RC_ASSERT(kinematics.jacobian(near).allFinite());
    }
  }));
}

}  // namespace
}  // namespace mrroc
