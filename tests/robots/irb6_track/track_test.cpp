#include <gtest/gtest.h>

#include <cmath>

#include "robots/irb6/family/cases.hpp"
#include "robots/irb6/irb6_model.hpp"

namespace mrroc {
namespace {

const RobotModel& track_still() { return *robot_under_test().models.at(0); }
const RobotModel& track_used() { return *robot_under_test().models.at(1); }

JointVector near_posture(const JointVector& joints, double change) {
  JointVector near = joints;
  for (int i = 0; i < near.size(); ++i) near[i] += any_between(-change, change);
  return near;
}

TEST(Irb6Track, EqualsTheIrb6WithTheTrackAtZero) {
  const auto irb6 = load_irb6(robot_file("irb6", "toml"));
  EXPECT_TRUE(rc::check([&] {
    JointVector joints = any_posture();
    joints[0] = 0;
    RC_ASSERT(pose_difference(robot().flange(joints), irb6.front()->flange(joints.tail<6>())) < 1e-12);
  }));
}

TEST(Irb6Track, TrackCarriesTheArmAlongY) {
  const JointVector home = robot().parameters().home;
  JointVector moved = home, motors_home, motors_moved;
  moved[0] += 0.1;
  EXPECT_LT(
      (robot().flange(moved).translation() - robot().flange(home).translation() - Eigen::Vector3d(0, 0.1, 0)).norm(),
      1e-12);
  ASSERT_EQ(robot().joints_to_motors(home, motors_home), ErrorCode::none);
  ASSERT_EQ(robot().joints_to_motors(moved, motors_moved), ErrorCode::none);
  EXPECT_NEAR(motors_moved[0] - motors_home[0], 50 * M_PI, 1e-9) << "25 turns of the motor";
  EXPECT_EQ(motors_moved.tail<6>(), motors_home.tail<6>());
}

TEST(Irb6Track, TrackStillKeepsTheTrack) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_posture();
    JointVector found, near = near_posture(joints, 0.1);
    if (track_still().inverse(track_still().flange(joints), near, found) != ErrorCode::none) return;
    RC_ASSERT(found[0] == near[0]);
  }));
}

TEST(Irb6Track, TrackUsedKeepsTheColumn) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_posture();
    JointVector found, near = near_posture(joints, 0.1);
    if (track_used().inverse(track_used().flange(joints), near, found) != ErrorCode::none) return;
    RC_ASSERT(std::abs(found[1] - near[1]) < 1e-9);
    RC_ASSERT(pose_difference(track_used().flange(found), track_used().flange(joints)) < 1e-9);
  }));
}

// with the tool down the original's rule, which keeps the wrist roll, leaves the column undetermined
TEST(Irb6Track, TrackUsedFollowsALineAlongTheTrackWithTheTrackAlone) {
  const JointVector home = robot().parameters().home;
  JointVector joints = home;
  Pose pose = track_used().flange(home);
  for (int i = 0; i < 600; ++i) {
    pose.translation().y() += 0.001;
    ASSERT_EQ(track_used().inverse(pose, joints, joints), ErrorCode::none);
  }
  JointVector expected = home;
  expected[0] += 0.6;
  EXPECT_LT((joints - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Irb6Track, ModelsReachThePoseWithDifferentJoints) {
  const JointVector home = robot().parameters().home;
  Pose pose = robot().flange(home);
  pose.translation().y() += 0.2;
  JointVector still, used;
  ASSERT_EQ(track_still().inverse(pose, home, still), ErrorCode::none);
  ASSERT_EQ(track_used().inverse(pose, home, used), ErrorCode::none);
  EXPECT_EQ(still[0], home[0]);
  EXPECT_NEAR(still[1], std::atan2(0.2, 0.75), 1e-8);
  EXPECT_NEAR(used[0], home[0] + 0.2, 1e-9);
  EXPECT_NEAR(used[1], home[1], 1e-9);
}

TEST(Irb6Track, KeepsTheTrackWithTheArmAlongIt) {
  for (const double column : {M_PI / 2, -M_PI / 2}) {
    JointVector joints = robot().parameters().home, found;
    joints[1] = column;
    EXPECT_EQ(track_used().inverse(track_used().flange(joints), joints, found), ErrorCode::singular);
    EXPECT_LT((found - joints).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(Irb6Track, TrackUsedDoesNotReachBehindTheArm) {
  const JointVector home = robot().parameters().home;
  Pose pose = track_used().flange(home);
  pose.translation().x() = -pose.translation().x();
  JointVector joints = home;
  EXPECT_EQ(track_used().inverse(pose, home, joints), ErrorCode::out_of_workspace);
  EXPECT_EQ(joints, home) << "unchanged";
}

TEST(Irb6Track, CalibratedModelPlacesTheToolNearThatOfTheNominalOne) {
  const RobotModel& calibrated = *robot_under_test().models.at(2);
  std::mt19937_64 random(20060108);
  double worst_distance = 0, worst_angle = 0;
  for (int i = 0; i < 5000; ++i) {
    JointVector motors, joints;
    const JointVector posture = random_posture(random);
    ASSERT_EQ(robot().joints_to_motors(posture, motors), ErrorCode::none);
    ASSERT_EQ(calibrated.motors_to_joints(motors, joints), ErrorCode::none);
    const Pose nominal = arm().direct(posture), measured = ToolKinematics(calibrated).direct(joints);
    worst_distance = std::max(worst_distance, (nominal.translation() - measured.translation()).norm());
    worst_angle = std::max(worst_angle, pose_difference(Pose(nominal.rotation()), Pose(measured.rotation())));
  }
  std::printf("worst of 5000 postures: %.0f mm, %.3f rad\n", 1000 * worst_distance, worst_angle);
  EXPECT_LT(worst_distance, 0.12);
  EXPECT_LT(worst_angle, 0.15);
}

}  // namespace
}  // namespace mrroc
