#include <gtest/gtest.h>

#include "gripper_fixture.hpp"
#include "robots/common/any_number.hpp"

namespace mrroc::kinematics_test {
namespace {

constexpr double kReach = 0.125;

Pose at(double x) {
  Pose pose = Pose::Identity();
  pose.translation() << x, 0, kReach;
  return pose;
}

TEST(GripperKinematics, FlangeIsOnTheFirstFingersPad) {
  EXPECT_TRUE(rc::check([] {
    const double opening = any_between(0, 0.1);
    RC_ASSERT(gripper_model()->flange(one(opening)).matrix() == at(opening / 2).matrix());
  }));
}

TEST(GripperKinematics, InverseOfAFlangePoseIsItsOpeningExactly) {
  EXPECT_TRUE(rc::check([] {
    const JointVector opening = one(any_between(0, 0.1)), elsewhere = one(any_between(0, 0.1));
    JointVector found;
    RC_ASSERT(gripper_model()->inverse(gripper_model()->flange(opening), elsewhere, found) == ErrorCode::none);
    RC_ASSERT(found == opening);
  }));
}

TEST(GripperKinematics, PosesOffTheLineAreOutOfWorkspace) {
  EXPECT_TRUE(rc::check([] {
    Pose pose = at(any_between(0, 0.05));
    const double off = *rc::gen::element(1e-5, -1e-5, 0.1, -3.0);
    const int way = *rc::gen::inRange(0, 5);
    if (way < 2) {
      pose.translation()[way + 1] += off;
    } else {
      pose.linear() = Eigen::AngleAxisd(off, Eigen::Vector3d::Unit(way - 2)).toRotationMatrix();
    }
    JointVector joints = one(7);
    RC_ASSERT(gripper_model()->inverse(pose, one(0.06), joints) == ErrorCode::out_of_workspace);
    RC_ASSERT(joints == one(7));
  }));
}

TEST(GripperKinematics, JacobianIsTheDerivativeOfThePoseForEveryPoint) {
  const Jacobian jacobian = gripper_model()->jacobian(one(0.06), {1, 2, 3});
  ASSERT_EQ(jacobian.cols(), 1);
  const Eigen::Vector3d step = gripper_model()->flange(one(0.07)) * Eigen::Vector3d(1, 2, 3) -
                               gripper_model()->flange(one(0.06)) * Eigen::Vector3d(1, 2, 3);
  EXPECT_LT((jacobian.col(0).head<3>() - step / 0.01).norm(), 1e-12);
  EXPECT_EQ(jacobian.col(0).tail<3>().norm(), 0);
}

TEST(GripperKinematics, InvalidPoseIsOutOfWorkspace) {
  EXPECT_TRUE(rc::check([] {
    Pose pose = at(any_garbage());
    const int row = *rc::gen::inRange(0, 3), column = *rc::gen::inRange(0, 4);
    pose.matrix()(row, column) = any_garbage();
    JointVector joints = one(7);
    const ErrorCode code = gripper_model()->inverse(pose, one(any_garbage()), joints);
    RC_ASSERT(joints.allFinite());
    RC_ASSERT(code == ErrorCode::out_of_workspace || pose.matrix().allFinite());
    RC_ASSERT(code == ErrorCode::none || joints == one(7));
  }));
}

}  // namespace
}  // namespace mrroc::kinematics_test
