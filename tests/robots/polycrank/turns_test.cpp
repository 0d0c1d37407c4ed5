#include <gtest/gtest.h>

#include "robots/polycrank/polycrank_cases.hpp"

namespace mrroc::turns_test {
namespace {

TEST(PolycrankTurns, WholeTurnsOfNearAreKeptByEveryJoint) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_joints(), near = any_near(joints, 0.3);
    RC_PRE(dexterity(joints) > 0.02);
    JointVector turns(7);
    for (int i = 0; i < 7; ++i) turns[i] = 2 * M_PI * *rc::gen::inRange(-1000, 1001);
    const Pose pose = polycrank_model().flange(joints);
    JointVector here, turned;
    RC_ASSERT(polycrank_model().inverse(pose, near, here) == ErrorCode::none);
    RC_ASSERT(polycrank_model().inverse(pose, near + turns, turned) == ErrorCode::none);
    RC_ASSERT((turned - here - turns).cwiseAbs().maxCoeff() < 1e-8);
  }));
}

TEST(PolycrankTurns, RollOfTheToolCountsItsTurns) {
  JointVector joints = polycrank_home();
  const Pose start = polycrank_model().flange(joints);
  constexpr int kTurns = 50, kStepsPerTurn = 60;
  for (int i = 1; i <= kTurns * kStepsPerTurn; ++i) {
    const Pose pose = start * Eigen::AngleAxisd(2 * M_PI * i / kStepsPerTurn, Eigen::Vector3d::UnitZ());
    ASSERT_EQ(polycrank_model().inverse(pose, joints, joints), ErrorCode::none);
  }
  EXPECT_NEAR(joints[6], polycrank_home()[6] + 2 * M_PI * kTurns, 1e-8);
  EXPECT_LT((joints - polycrank_home()).head<6>().cwiseAbs().maxCoeff(), 1e-8);
}

// the whole flange pose rotates about the first axis: only the three cranks about it can follow, turn after turn
TEST(PolycrankTurns, ShoulderCountsItsTurnsAboutTheFirstAxis) {
  JointVector joints = polycrank_home();
  const Pose start = polycrank_model().flange(joints);
  constexpr int kTurns = 20, kStepsPerTurn = 200;
  double longest_step = 0;
  for (int i = 1; i <= kTurns * kStepsPerTurn; ++i) {
    const Pose pose = Pose(Eigen::AngleAxisd(2 * M_PI * i / kStepsPerTurn, Eigen::Vector3d::UnitX())) * start;
    const JointVector before = joints;
    ASSERT_EQ(polycrank_model().inverse(pose, before, joints), ErrorCode::none);
    ASSERT_LT(pose_difference(polycrank_model().flange(joints), pose), 1e-9);
    longest_step = std::max(longest_step, (joints - before).norm());
  }
  EXPECT_NEAR((joints - polycrank_home()).head<3>().sum(), 2 * M_PI * kTurns, 1e-8);
  EXPECT_LT(longest_step, 2.5 * 2 * M_PI / kStepsPerTurn);
}

TEST(PolycrankTurns, MotorsAndJointsAgreeTenThousandTurnsAway) {
  const JointVector joints = polycrank_home() + JointVector::Constant(7, 2 * M_PI * 10000);
  JointVector motors, back;
  ASSERT_EQ(polycrank_model().joints_to_motors(joints, motors), ErrorCode::none);
  ASSERT_EQ(polycrank_model().motors_to_joints(motors, back), ErrorCode::none);
  EXPECT_LT((back - joints).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT(pose_difference(polycrank_model().flange(joints), polycrank_model().flange(polycrank_home())), 1e-9);
}

}  // namespace
}  // namespace mrroc::turns_test
