#include "robots/arm/arm_model.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "config/table.hpp"
#include "edp/check/robot_check.hpp"
#include "mrroc/testing/scratch_folder.hpp"
#include "robots/arm/arm_fixture.hpp"
#include "robots/common/changed_file.hpp"

namespace mrroc {
namespace {

std::string error_with(const std::string& from, const std::string& to) {
  return error_of_changed(load_arm, kBenchArm, from, to);
}

TEST(ArmModel, IsTheProductOfItsJoints) {
  const RobotModels models = load_arm(kBenchArm);
  const RobotModel& model = *models.front();
  edp::check_robot(models, "bench_arm", {kBenchArm, "", "", ""});
  EXPECT_EQ(model.joint_count(), 6);
  // the arm stretched along -x: the lengths of its links
  const Eigen::Vector3d stretched = model.flange(JointVector::Zero(6)).translation();
  EXPECT_TRUE(stretched.isApprox(Eigen::Vector3d(-0.425 - 0.3922, -0.1333 - 0.0996, 0.1625 - 0.0997), 1e-12))
      << stretched.transpose();
}

TEST(ArmModel, AnotherModelHasWhatItDoesNotLeaveOut) {
  const RobotModels models = load_arm(kBenchArm);
  ASSERT_EQ(models.size(), 2U);
  EXPECT_EQ(models[1]->name(), "calibrated");
  const JointVector home = models[0]->parameters().home;
  const Pose nominal = models[0]->flange(home), calibrated = models[1]->flange(home);
  const double distance = (nominal.translation() - calibrated.translation()).norm();
  EXPECT_GT(distance, 1e-4);
  EXPECT_LT(distance, 2e-3);
  JointVector joints;
  ASSERT_EQ(models[1]->inverse(calibrated, home, joints), ErrorCode::none);
  EXPECT_LT((joints - home).norm(), 1e-6);
}

TEST(ArmModel, AJointMaySlideAndHaveAGear) {
  const task_test::ScratchFolder folder;
  const auto file = folder.write("rail.toml", R"(type = "rail"
home = [0.1]
[[axes]]
name = "rail"
position_min = 0
position_max = 2
velocity_max = 1
acceleration_max = 2
jerk_max = 20
motor_min = -1
motor_max = 220
motor_synchro = 0
current_max = 10
following_error_max = 1
regulator_a = 0.4
regulator_b0 = 1.5
regulator_b1 = 1.4
regulator_eps = 0.01
regulator_current_gain = 0.2
torque_constant = 0.1
rotor_inertia = 1e-4
viscous_friction = 0.02
[chain]
base = "base"
tip = "carriage"
flange = [0, 0, 0.5, 0, 0, 0]
[chain.joints]
rail = { frame = [1, 0, 0, 0, 0, 1.5707963267948966], axis = [2, 0, 0], kind = "slides", gear = 100 }
)");
  const RobotModels models = load_arm(file);
  const JointVector q = JointVector::Constant(1, 0.3);
  EXPECT_TRUE(models[0]->flange(q).translation().isApprox(Eigen::Vector3d(1, 0.3, 0.5), 1e-12));
  JointVector motors;
  ASSERT_EQ(models[0]->joints_to_motors(q, motors), ErrorCode::none);
  EXPECT_NEAR(motors[0], 30, 1e-12);
  EXPECT_EQ(models[0]->joint_period(0), 0);
}

TEST(ArmModel, ErrorsNameTheirKey) {
  EXPECT_EQ(error_with("0.1625", "0.1626"), "");
  EXPECT_TRUE(names(error_with("[chain]", "[chian]"), "chain.base: missing"));
  EXPECT_TRUE(names(error_with("tip = \"tool\"", ""), "chain.tip: missing"));
  EXPECT_TRUE(names(error_with("flange = [0.0, 0.0, 0.0,", "flange = [0.0, 0.0,"), "chain.flange"));
  EXPECT_TRUE(names(error_with("elbow = { frame", "ellbow = { frame"), "chain.joints.ellbow: unknown key"));
  EXPECT_TRUE(names(error_with("[-0.425,", "[-425,"), "chain.joints.elbow.frame: -425 is out of range"));
  EXPECT_TRUE(names(error_with("axis = [0.0, 0.0, 1.0] }", "axis = [0.0, 0.0, 0.0] }"), "chain.joints.pan.axis"));
  EXPECT_TRUE(names(error_with("axis = [0.0, 0.0, 1.0] }", "axis = [0.0, 0.0, 1.0], gear = 0 }"), "joints.pan.gear"));
  EXPECT_TRUE(names(error_with("axis = [0.0, 0.0, 1.0] }", "axis = [0.0, 0.0, 1.0], kind = \"bends\" }"), "pan.kind"));
  EXPECT_TRUE(names(error_with("axis = [0.0, 0.0, 1.0] }", "axis = [0.0, 0.0, 1.0], turns = 1 }"), "pan.turns"));
  EXPECT_TRUE(names(error_with(", axis = [0.0, 0.0, 1.0] }", " }"), "chain.joints.pan.axis: missing"));
  EXPECT_TRUE(names(error_with("[models.calibrated.joints]", "[models.nominal.joints]"), "models.nominal"));
  EXPECT_TRUE(names(error_with("[models.calibrated.joints]\nelbow", "[models.calibrated.joints]\nelbo"), "elbo"));
}

}  // namespace
}  // namespace mrroc
