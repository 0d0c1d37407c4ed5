#include <gtest/gtest.h>

#include <cmath>

#include "robots/irb6/family/cases.hpp"

namespace mrroc {
namespace {

JointVector joints_of(std::initializer_list<double> values) {
  JointVector joints(6);
  std::copy(values.begin(), values.end(), joints.data());
  return joints;
}

bool nearly_aligned(const JointVector& joints) { return std::abs(std::sin(joints[4])) < 1e-6; }

TEST(Irb6Kinematics, InverseReachesThePoseFromAnyStart) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_posture(), near = any_posture();
    const Pose pose = arm().direct(joints);
    JointVector found;
    RC_ASSERT(arm().inverse(pose, near, found) != ErrorCode::out_of_workspace);
    RC_ASSERT(pose_difference(arm().direct(found), pose) < 1e-9);
  }));
}

TEST(Irb6Kinematics, InverseTakesTheNearerWristBranch) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_posture(), near = any_posture();
    RC_PRE(!nearly_aligned(joints));
    JointVector found;
    RC_ASSERT(arm().inverse(arm().direct(joints), near, found) == ErrorCode::none);
    const auto change = [&](const JointVector& q) { return (q - near).tail<3>().cwiseAbs().sum(); };
    RC_ASSERT(change(found) <= change(joints) + 1e-9);
  }));
}

TEST(Irb6Kinematics, InverseFollowsALineThroughTheWristSingularity) {
  JointVector joints = joints_of({0.1, -1.6, 0.1, 0.2, 0.05, 0.3});
  for (double roll = 0.05; roll > -0.05; roll -= 0.0007) {
    const JointVector wanted = joints_of({0.1, -1.6, 0.1, 0.2, roll, 0.3});
    const ErrorCode code = arm().inverse(arm().direct(wanted), joints, joints);
    ASSERT_NE(code, ErrorCode::out_of_workspace);
    ASSERT_LT((joints - wanted).cwiseAbs().maxCoeff(), 1e-6) << roll;
  }
}

TEST(Irb6Kinematics, WristRollKeepsItsTurn) {
  const JointVector joints = joints_of({0, -1.7, 0.4, -0.2, 8.5, 0.5});
  JointVector found;
  const JointVector near = joints_of({0, -1.7, 0.4, -0.2, 8.4, 0.5});
  ASSERT_EQ(arm().follow(arm().direct(joints), near, found), ErrorCode::none);
  EXPECT_NEAR(found[4], 8.5, 1e-9);
}

TEST(Irb6Kinematics, AlignedRollAxesAreSingularAndKeepThePitch) {
  for (const double roll : {0.0, M_PI, 2 * M_PI, 3 * M_PI, -M_PI}) {
    const JointVector joints = joints_of({0.3, -1.7, 0.3, -0.2, roll, 0.5});
    JointVector near = joints, found;
    near[3] += 0.05;
    const Pose pose = arm().direct(joints);
    ASSERT_EQ(arm().follow(pose, near, found), ErrorCode::singular) << roll;
    EXPECT_LT(pose_difference(arm().direct(found), pose), 1e-9);
    EXPECT_NEAR(found[1] + found[2] + found[3], near[1] + near[2] + near[3], 1e-9);
    EXPECT_NEAR(found[4], roll, 1e-9);
  }
}

TEST(Irb6Kinematics, AboveTheShoulderIsSingularAndKeepsTheColumn) {
  Pose pose = Pose::Identity();
  pose.translation().z() = 0.9;
  const Pose flange_pose = pose * robot().default_tool().inverse();
  ASSERT_EQ(flange_pose.translation().head<2>().norm(), 0);
  JointVector near = robot().parameters().home, found;
  near[0] = 0.7;
  ASSERT_EQ(arm().inverse(pose, near, found), ErrorCode::singular);
  EXPECT_EQ(found[0], 0.7);
  EXPECT_LT(pose_difference(arm().direct(found), pose), 1e-9);
}

TEST(Irb6Kinematics, PoseBeyondTheArmIsOutOfWorkspace) {
  const JointVector home = robot().parameters().home;
  for (const Eigen::Vector3d& offset : {Eigen::Vector3d(2, 0, 0), {0, 0, 3}, {-0.73, 0, -0.25}, {0, -5, 0}}) {
    Pose pose = arm().direct(home);
    pose.translation() += offset;
    JointVector joints = home;
    EXPECT_EQ(arm().inverse(pose, home, joints), ErrorCode::out_of_workspace) << offset.transpose();
    EXPECT_EQ(joints, home) << "unchanged";
  }
}

TEST(Irb6Kinematics, NonRigidTransformIsOutOfWorkspace) {
  const JointVector home = robot().parameters().home;
  Pose scaled = arm().direct(home), mirrored = scaled, broken = scaled;
  scaled.linear() *= 1.001;
  mirrored.linear().col(0) *= -1;
  broken.linear()(1, 1) = std::numeric_limits<double>::quiet_NaN();
  JointVector joints;
  EXPECT_EQ(arm().inverse(scaled, home, joints), ErrorCode::out_of_workspace);
  EXPECT_EQ(arm().inverse(mirrored, home, joints), ErrorCode::out_of_workspace);
  EXPECT_EQ(arm().inverse(broken, home, joints), ErrorCode::out_of_workspace);
}

}  // namespace
}  // namespace mrroc
