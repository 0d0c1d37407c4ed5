#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <vector>

#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

constexpr double kTolerance = 1e-9;

struct GoldenRow {
  JointVector joints, motors;
  Pose flange;
};

std::vector<GoldenRow> golden_rows() {
  std::ifstream file(std::string(MRROC_SOURCE_DIR) + "/tests/robots/irb6/kinematics_golden.csv");
  std::vector<GoldenRow> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("#") || line.starts_with("q1")) continue;
    std::array<double, 24> values{};
    std::istringstream stream(line);
    std::string cell;
    for (double& value : values) {
      if (!std::getline(stream, cell, ',')) throw std::runtime_error("short line in kinematics_golden.csv");
      value = std::stod(cell);
    }
    GoldenRow row;
    row.joints = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(values.data());
    row.motors = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(values.data() + 6);
    row.flange.matrix().topRows<3>() = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(&values[12]);
    row.flange.matrix().row(3) << 0, 0, 0, 1;
    rows.push_back(row);
  }
  return rows;
}

TEST(Irb6Golden, MotorsJointsAndPosesAgreeWithTheOriginal) {
  const auto rows = golden_rows();
  ASSERT_EQ(rows.size(), 500u);
  const RobotModel& model = robot();
  double worst_motor = 0, worst_joint = 0, worst_pose = 0, worst_inverse = 0;
  for (const GoldenRow& row : rows) {
    JointVector motors, joints, inverse;
    ASSERT_EQ(model.joints_to_motors(row.joints, motors), ErrorCode::none);
    ASSERT_EQ(model.motors_to_joints(row.motors, joints), ErrorCode::none);
    ASSERT_EQ(model.inverse(row.flange, row.joints, inverse), ErrorCode::none);
    worst_motor = std::max(worst_motor, (motors - row.motors).cwiseAbs().maxCoeff());
    worst_joint = std::max(worst_joint, (joints - row.joints).cwiseAbs().maxCoeff());
    worst_pose = std::max(worst_pose, pose_difference(model.flange(row.joints), row.flange));
    worst_inverse = std::max(worst_inverse, (inverse - row.joints).cwiseAbs().maxCoeff());
  }
  std::printf("worst of 500: motors %.1e rad, joints %.1e rad, pose %.1e m or rad, inverse %.1e rad\n", worst_motor,
              worst_joint, worst_pose, worst_inverse);
  EXPECT_LT(worst_motor, kTolerance);
  EXPECT_LT(worst_joint, kTolerance);
  EXPECT_LT(worst_pose, kTolerance);
  EXPECT_LT(worst_inverse, kTolerance);
}

TEST(Irb6Golden, SynchronisedArmIsUprightWithItsForearmLevel) {
  JointVector joints;
  ASSERT_EQ(robot().motors_to_joints(per_axis(&AxisParameters::motor_synchro), joints), ErrorCode::none);
  JointVector expected(6);
  expected << 0, -M_PI / 2, 0, 0, 0, 0;
  EXPECT_LT((joints - expected).cwiseAbs().maxCoeff(), 1e-6);  // the original's lengths are rounded to 0.1 um
  const Pose flange = robot().flange(expected);
  Pose upright = Pose::Identity();
  upright.linear() << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  upright.translation() << 0.86, 0, 0.455;
  EXPECT_LT(pose_difference(flange, upright), 1e-12);
}

TEST(Irb6Golden, FrontPosition) {
  JointVector front(6), motors, expected(6);
  front << 0, -1.57, 0, 1.56, 1.57, -1.57;
  expected << -15.9, -4.861709, -8.387478, -48.471930, 114.892070, 337.451335;
  ASSERT_EQ(robot().joints_to_motors(front, motors), ErrorCode::none);
  EXPECT_LT((motors - expected).cwiseAbs().maxCoeff(), 1e-6);
}

}  // namespace
}  // namespace mrroc
