#include <gtest/gtest.h>

#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

const RobotModel& calibrated() { return *robot_under_test().models.at(1); }

TEST(Irb6Calibrated, IsTheSecondModel) {
  EXPECT_EQ(robot_under_test().models.size(), 2u);
  EXPECT_EQ(robot().name(), "nominal");
  EXPECT_EQ(calibrated().name(), "calibrated");
}

TEST(Irb6Calibrated, SynchronisationPostureEqualsItsOffsets) {
  JointVector synchro(6), joints;
  synchro << -7.7597, -8.7537, -7.5355, 153.1366, 430.2282, 796.0265;
  ASSERT_EQ(calibrated().motors_to_joints(synchro, joints), ErrorCode::none);
  EXPECT_NEAR(joints[0], 0.0111, 1e-12);
  EXPECT_NEAR(joints[4], 0.0903, 1e-12);
  EXPECT_NEAR(joints[5], 0.0209, 1e-12);
  EXPECT_NEAR(joints[1] + joints[2] + joints[3], -M_PI / 2, 1e-12) << "the wrist is level there";
  // calculated with the original's formula: l = 211.8108 mm and 187.6529 mm
  EXPECT_NEAR(joints[1], -1.5886, 1e-4);
  EXPECT_NEAR(joints[2], 0.0121, 1e-4);
}

// both models read the same encoders of the same arm: they may differ by the amount of a calibration, not by a quarter
// turn
TEST(Irb6Calibrated, PlacesTheToolNearThePoseOfTheNominalModel) {
  std::mt19937_64 random(20060107);
  double worst_distance = 0, worst_angle = 0;
  for (int i = 0; i < 5000; ++i) {
    JointVector motors, joints;
    const JointVector posture = random_posture(random);
    ASSERT_EQ(robot().joints_to_motors(posture, motors), ErrorCode::none);
    ASSERT_EQ(calibrated().motors_to_joints(motors, joints), ErrorCode::none);
    const Pose nominal = arm().direct(posture), measured = ToolKinematics(calibrated()).direct(joints);
    worst_distance = std::max(worst_distance, (nominal.translation() - measured.translation()).norm());
    worst_angle = std::max(worst_angle, pose_difference(Pose(nominal.rotation()), Pose(measured.rotation())));
  }
  std::printf("worst of 5000 postures: %.0f mm, %.3f rad\n", 1000 * worst_distance, worst_angle);
  EXPECT_LT(worst_distance, 0.12);
  EXPECT_LT(worst_angle, 0.12);
  EXPECT_GT(worst_distance, 0.02) << "it is a different model";
}

}  // namespace
}  // namespace mrroc
