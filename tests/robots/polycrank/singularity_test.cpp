#include <gtest/gtest.h>

#include "robots/polycrank/polycrank_cases.hpp"

namespace mrroc::singularity_test {
namespace {

double shoulder_sum(const JointVector& joints) { return joints.head<3>().sum(); }

/// Joints with q4 + q5 + q6 = `wrist`.
JointVector with_wrist(double wrist) { return joints_of({0.3, 1.1, -0.7, 0.4, 1.0, wrist - 1.4, 0.6}); }

TEST(PolycrankSingularity, AlignedRollAxesKeepTheShouldersSum) {
  for (const double wrist : {0.0, M_PI, 2 * M_PI, -M_PI}) {
    const JointVector joints = with_wrist(wrist);
    const Pose pose = polycrank_model().flange(joints);
    JointVector near = joints, found;
    near[2] += 0.05;
    ASSERT_EQ(polycrank_model().inverse(pose, near, found), ErrorCode::singular) << wrist;
    EXPECT_LT(pose_difference(polycrank_model().flange(found), pose), 1e-9);
    EXPECT_NEAR(shoulder_sum(found), shoulder_sum(near), 1e-9);
    ASSERT_EQ(polycrank_model().inverse(pose, joints, found), ErrorCode::singular) << wrist;
    EXPECT_LT((found - joints).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(PolycrankSingularity, PathContinuesStraightThroughAlignedRollAxes) {
  JointVector joints = with_wrist(0.05);
  const double sum = shoulder_sum(joints), roll = joints[6];
  for (double wrist = 0.05; wrist > -0.05; wrist -= 0.0007) {
    const Pose pose = polycrank_model().flange(with_wrist(wrist));
    ASSERT_NE(polycrank_model().inverse(pose, joints, joints), ErrorCode::out_of_workspace);
    ASSERT_LT(pose_difference(polycrank_model().flange(joints), pose), 1e-9);
    ASSERT_NEAR(joints.segment<3>(3).sum(), wrist, 1e-9);
    ASSERT_NEAR(shoulder_sum(joints), sum, 1e-6);
    ASSERT_NEAR(joints[6], roll, 1e-6);
  }
}

TEST(PolycrankSingularity, FoldedElbowPairKeepsItsFirstCrank) {
  const JointVector joints = joints_of({0.3, 1.1, -0.7, 0.4, M_PI, -2.0, 0.6});
  const Pose pose = polycrank_model().flange(joints);
  for (const double change : {0.0, 0.7}) {
    JointVector near = joints, found;
    near[3] += change;
    near[5] -= change;  // the same posture, since the crank's end stays on its axis
    ASSERT_LT(pose_difference(polycrank_model().flange(near), pose), 1e-12);
    ASSERT_EQ(polycrank_model().inverse(pose, near, found), ErrorCode::singular);
    EXPECT_LT((found - near).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(PolycrankSingularity, StretchedPairIsAFixedPointAndNotSingular) {
  for (const int bend : {1, 4}) {
    JointVector joints = joints_of({0.3, 1.1, -0.7, 0.4, 1.0, 0.5, 0.6}), found;
    joints[bend] = 0;
    ASSERT_EQ(polycrank_model().inverse(polycrank_model().flange(joints), joints, found), ErrorCode::none) << bend;
    EXPECT_LT((found - joints).cwiseAbs().maxCoeff(), 1e-6) << bend;
  }
}

TEST(PolycrankSingularity, BendMayChangeAlongAPath) {
  JointVector joints = joints_of({0.3, 0.1, -0.7, 0.4, 1.0, 0.5, 0.6});
  for (double bend = 0.1; bend > -0.1; bend -= 0.0013) {
    JointVector wanted = joints_of({0.3, bend, -0.7, 0.4, 1.0, 0.5, 0.6});
    const Pose pose = polycrank_model().flange(wanted);
    const JointVector before = joints;
    ASSERT_EQ(polycrank_model().inverse(pose, before, joints), ErrorCode::none);
    ASSERT_LT(pose_difference(polycrank_model().flange(joints), pose), 1e-9);
    ASSERT_LT((joints - before).norm(), 0.002) << bend;
  }
}

}  // namespace
}  // namespace mrroc::singularity_test
