#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "mrroc/robots/irb6_five_axis.hpp"
#include "robots/irb6/family/cases.hpp"
#include "robots/irb6/family/changed_file.hpp"
#include "robots/irb6_five_axis/five_axis_kinematics.hpp"
#include "robots/irb6_five_axis/irb6_five_axis_model.hpp"

namespace mrroc {
namespace {

constexpr double kTolerance = irb6::FiveAxisKinematics::kPlaneTolerance;

Pose rotate_twist(const Pose& pose, double angle, const Eigen::Vector3d& flange_axis) {
  return pose * Eigen::AngleAxisd(angle, flange_axis);
}

TEST(Irb6FiveAxis, InverseReachesThePoseFromAnyStart) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_posture();
    JointVector found;
    RC_ASSERT(robot().inverse(robot().flange(joints), any_posture(), found) == ErrorCode::none);
    RC_ASSERT(pose_difference(robot().flange(found), robot().flange(joints)) < 1e-9);
  }));
}

TEST(Irb6FiveAxis, ToolOutsideTheArmsPlaneIsOutOfWorkspace) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_posture();
    const Pose pose = robot().flange(joints);
    // about the direction in the arm's plane at right angles to the tool, so the tool leaves the plane
    const Eigen::Vector3d across(std::cos(joints[4]), -std::sin(joints[4]), 0);
    const double angle = any_between(2 * kTolerance, 1) * (*rc::gen::arbitrary<bool>() ? 1 : -1);
    JointVector found = joints;
    RC_ASSERT(robot().inverse(rotate_twist(pose, angle, across), joints, found) == ErrorCode::out_of_workspace);
    RC_ASSERT(found == joints);
    RC_ASSERT(robot().inverse(rotate_twist(pose, kTolerance / 2, across), joints, found) == ErrorCode::none);
    RC_ASSERT(pose_difference(robot().flange(found), pose) < 1.1 * kTolerance);
  }));
}

TEST(Irb6FiveAxis, VerticalToolMayHaveAnyPositionAndRotation) {
  EXPECT_TRUE(rc::check([] {
    Pose pose = Irb6FiveAxis::tool_down(any_between(0.4, 0.8), any_between(-0.3, 0.3), any_between(-0.1, 0.2));
    pose = rotate_twist(pose, any_between(-3, 3), Eigen::Vector3d::UnitZ());
    JointVector found;
    RC_ASSERT(arm().inverse(pose, robot().parameters().home, found) == ErrorCode::none);
    RC_ASSERT(pose_difference(arm().direct(found), pose) < 1e-9);
  }));
}

// the original clamped values slightly beyond a limit to the lower one, so they jumped across the range (defect 26)
TEST(Irb6FiveAxis, SolutionsBeyondALimitStayBeyondIt) {
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  std::mt19937_64 random(20060109);
  for (int axis = 0; axis < 5; ++axis) {
    for (const double beyond : {low[axis] - 1e-3, low[axis] - 1e-9, high[axis] + 1e-9, high[axis] + 1e-3}) {
      for (int i = 0; i < 100; ++i) {
        JointVector joints = random_posture(random), found;
        joints[axis] = beyond;
        ASSERT_EQ(robot().inverse(robot().flange(joints), joints, found), ErrorCode::none);
        ASSERT_LT((found - joints).cwiseAbs().maxCoeff(), 1e-9) << joints.transpose();
      }
    }
  }
}

TEST(Irb6FiveAxis, ToolDeterminesTheColumnAboveTheShoulder) {
  JointVector joints(5), near, found;
  // the arm folded back so that the wrist's end is over the column's axis, the tool still tilted in its plane
  const double t2 = -2.1, t4 = -0.4;
  const double t3 = std::acos((-0.455 * std::cos(t2) - 0.095 * std::cos(t4)) / 0.67);
  joints << 0.3, t2, -t3 - t2 - M_PI / 2, t4 + t3, 0.2;
  const Pose pose = robot().flange(joints);
  ASSERT_LT(pose.translation().head<2>().norm(), 1e-12);
  near = joints;
  near[0] += 0.5;
  ASSERT_EQ(robot().inverse(pose, near, found), ErrorCode::singular);
  EXPECT_NEAR(found[0], 0.3, 1e-9);
  EXPECT_LT(pose_difference(robot().flange(found), pose), 1e-9);
}

TEST(Irb6FiveAxis, ToolPointsForwardAtSynchronisation) {
  JointVector joints;
  ASSERT_EQ(robot().motors_to_joints(per_axis(&AxisParameters::motor_synchro), joints), ErrorCode::none);
  Pose expected = Pose::Identity();
  expected.linear() << 0, 0, 1, 0, -1, 0, 1, 0, 0;
  expected.translation() << 0.67 + 0.095, 0, 0.455;
  EXPECT_LT(pose_difference(robot().flange(joints), expected), 1e-6);  // the original's lengths are rounded to 0.1 um
}

TEST(Irb6FiveAxisFile, ErrorsNameTheirKey) {
  const auto mistake = [](const std::string& from, const std::string& to) {
    return error_with([](const std::filesystem::path& file) { return load_irb6_five_axis(file); }, from, to);
  };
  using testing::HasSubstr;
  EXPECT_THAT(mistake("wrist_roll_gear = -76.8", "wrist_roll_gear = -76.8\ntool_roll_gear = 1.0"),
              HasSubstr("tool_roll_gear"));
  EXPECT_THAT(mistake("wrist = 0.095", "wrist = 50"), HasSubstr("geometry.wrist"));
  EXPECT_THAT(mistake("position_max = 8.11", "position_max = -8.11"), HasSubstr("position_max"));
  EXPECT_EQ(load_irb6_five_axis().front()->parameters().type, "irb6_five_axis");
}

}  // namespace
}  // namespace mrroc
