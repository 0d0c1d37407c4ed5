#include <gtest/gtest.h>

#include "robots/common/any_number.hpp"
#include "robots/conveyor/conveyor_fixture.hpp"

namespace mrroc {
namespace {

Pose on_line(double x) {
  Pose pose = Pose::Identity();
  pose.translation().x() = x;
  return pose;
}

TEST(ConveyorKinematics, FlangeIsTheBaseMovedByTheTravel) {
  EXPECT_TRUE(rc::check([] {
    const double travel = any_between(-1000, 1000);
    RC_ASSERT(conveyor_model()->flange(one(travel)).matrix() == on_line(travel).matrix());
  }));
}

TEST(ConveyorKinematics, InverseOfAFlangePoseIsItsTravelExactly) {
  EXPECT_TRUE(rc::check([] {
    const JointVector travel = one(any_between(-1000, 1000)), elsewhere = one(any_between(-1000, 1000));
    JointVector found;
    RC_ASSERT(conveyor_model()->inverse(conveyor_model()->flange(travel), elsewhere, found) == ErrorCode::none);
    RC_ASSERT(found == travel);
  }));
}

TEST(ConveyorKinematics, PosesOffTheLineAreOutOfWorkspace) {
  EXPECT_TRUE(rc::check([] {
    Pose pose = on_line(any_between(-10, 10));
    const double off = *rc::gen::element(1e-5, -1e-5, 0.1, -3.0);
    const int way = *rc::gen::inRange(0, 5);
    if (way < 2) {
      pose.translation()[way + 1] += off;
    } else {
      pose.linear() = Eigen::AngleAxisd(off, Eigen::Vector3d::Unit(way - 2)).toRotationMatrix();
    }
    JointVector joints = one(7);
    RC_ASSERT(conveyor_model()->inverse(pose, one(0), joints) == ErrorCode::out_of_workspace);
    RC_ASSERT(joints == one(7));
  }));
}

TEST(ConveyorKinematics, RoundingDoesNotMoveAPoseOffTheLine) {
  Pose pose = on_line(1.5);
  pose.translation().y() = 5e-7;
  pose.linear() = Eigen::AngleAxisd(5e-7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  JointVector joints;
  ASSERT_EQ(conveyor_model()->inverse(pose, one(0), joints), ErrorCode::none);
  EXPECT_EQ(joints, one(1.5));
}

TEST(ConveyorKinematics, JacobianIsTheDerivativeOfThePoseForEveryPoint) {
  const Jacobian jacobian = conveyor_model()->jacobian(one(0.3), {1, 2, 3});
  ASSERT_EQ(jacobian.cols(), 1);
  const Eigen::Vector3d step = conveyor_model()->flange(one(1.3)) * Eigen::Vector3d(1, 2, 3) -
                               conveyor_model()->flange(one(0.3)) * Eigen::Vector3d(1, 2, 3);
  EXPECT_LT((jacobian.col(0).head<3>() - step).norm(), 1e-15);
  EXPECT_EQ(jacobian.col(0).tail<3>().norm(), 0);
}

TEST(ConveyorKinematics, InvalidPoseIsOutOfWorkspace) {
  EXPECT_TRUE(rc::check([] {
    Pose pose = on_line(any_garbage());
    const int row = *rc::gen::inRange(0, 3), column = *rc::gen::inRange(0, 4);
    pose.matrix()(row, column) = any_garbage();
    JointVector joints = one(7);
    const ErrorCode code = conveyor_model()->inverse(pose, one(any_garbage()), joints);
    RC_ASSERT(joints.allFinite());
    RC_ASSERT(code == ErrorCode::out_of_workspace || pose.matrix().allFinite());
    RC_ASSERT(code == ErrorCode::none || joints == one(7));
  }));
}

}  // namespace
}  // namespace mrroc
