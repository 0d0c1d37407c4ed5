#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <random>

#include "gripper_fixture.hpp"
#include "robots/common/kdl_chain.hpp"
#include "robots/common/loaded_mjcf.hpp"

namespace mrroc::descriptions_test {
namespace {

/// Positions of the passive joint and of the driven joint that moves on it.
JointVector both(double opening) {
  JointVector joints(2);
  joints << opening / 2, opening;
  return joints;
}

TEST(GripperDescriptions, UrdfMjcfAndClosedFormPlaceTheToolEqually) {
  const KDL::Chain chain = kdl_chain(gripper_source("two_finger_gripper.urdf"), "tool_frame");
  ASSERT_EQ(chain.getNrOfJoints(), 2U);
  KDL::ChainFkSolverPos_recursive forward(chain);
  LoadedMjcf mjcf(gripper_source("two_finger_gripper.xml"));
  ASSERT_EQ(mjcf.model->nq, 2);
  std::mt19937_64 random(20100622);
  std::uniform_real_distribution<double> any_opening(opening_axis().position_min, opening_axis().position_max);
  double worst_kdl = 0, worst_mujoco = 0;
  for (int i = 0; i < 10000; ++i) {
    const double opening = any_opening(random);
    const Pose pose = gripper_model()->flange(one(opening)) * gripper_model()->default_tool();
    KDL::JntArray joints(2);
    joints.data = both(opening);
    KDL::Frame frame;
    ASSERT_GE(forward.JntToCart(joints, frame), 0);
    mjcf.set_joints(both(opening));
    mj_kinematics(mjcf.model.get(), mjcf.data.get());
    worst_mujoco = std::max(worst_mujoco, (mjcf.site("tool").matrix() - pose.matrix()).norm());
    worst_kdl = std::max(worst_kdl, (pose_of(frame).matrix() - pose.matrix()).norm());
  }
  std::printf("worst of 10000 poses: URDF by KDL %.1e, MJCF %.1e\n", worst_kdl, worst_mujoco);
  EXPECT_LT(worst_kdl, 1e-9);
  EXPECT_LT(worst_mujoco, 1e-9);
}

TEST(GripperDescriptions, OpeningIsTheClearWidthBetweenThePadsAboutTheGripCentre) {
  LoadedMjcf mjcf(gripper_source("two_finger_gripper.xml"));
  mjcf.set_joints(both(0.07));
  mj_kinematics(mjcf.model.get(), mjcf.data.get());
  const auto surface = [&](const char* pad, double inward) {
    const int id = mj_name2id(mjcf.model.get(), mjOBJ_GEOM, pad);
    return mjcf.data->geom_xpos[3 * id] + inward * mjcf.model->geom_size[3 * id];
  };
  EXPECT_NEAR(surface("pad_left", -1), 0.035, 1e-12);
  EXPECT_NEAR(surface("pad_right", 1), -0.035, 1e-12);
  EXPECT_LT((mjcf.site("grip_centre").matrix() - gripper_model()->flange(one(0)).matrix()).norm(), 1e-12);
}

TEST(GripperDescriptions, NamesLimitsAndMassesAreTheSame) {
  const LoadedMjcf mjcf(gripper_source("two_finger_gripper.xml"));
  const auto urdf = urdf::parseURDFFile(gripper_source("two_finger_gripper.urdf").string());
  ASSERT_TRUE(urdf);
  const AxisParameters& axis = opening_axis();
  const int joint = mj_name2id(mjcf.model.get(), mjOBJ_JOINT, axis.name.c_str());
  ASSERT_EQ(joint, 1);
  EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_ACTUATOR, 0), axis.name);
  EXPECT_TRUE(mjcf.model->jnt_limited[joint]);
  EXPECT_EQ(mjcf.model->jnt_range[2 * joint], axis.position_min);
  EXPECT_EQ(mjcf.model->jnt_range[2 * joint + 1], axis.position_max);
  const auto opening = urdf->getJoint(axis.name), centring = urdf->getJoint("centring");
  ASSERT_TRUE(opening && centring && centring->mimic);
  EXPECT_EQ(opening->limits->lower, axis.position_min);
  EXPECT_EQ(opening->limits->upper, axis.position_max);
  EXPECT_EQ(opening->limits->velocity, axis.velocity_max);
  EXPECT_EQ(centring->mimic->joint_name, axis.name);
  EXPECT_EQ(centring->mimic->multiplier, 0.5);
  for (const char* link : {"base", "finger_left", "finger_right"}) {
    const int body = mj_name2id(mjcf.model.get(), mjOBJ_BODY, link);
    ASSERT_GE(body, 0);
    EXPECT_EQ(urdf->getLink(link)->inertial->mass, mjcf.model->body_mass[body]) << link;
  }
}

TEST(GripperDescriptions, ArmatureAndDampingAreThoseOfTheDriveAtHome) {
  const LoadedMjcf mjcf(gripper_source("two_finger_gripper.xml"));
  const double ratio = gripper_model()->transmission(gripper_model()->parameters().home)(0, 0);
  EXPECT_NEAR(mjcf.model->dof_armature[1] / (ratio * ratio * opening_axis().rotor_inertia), 1, 1e-3);
  EXPECT_NEAR(mjcf.model->dof_damping[1] / (ratio * ratio * opening_axis().viscous_friction), 1, 1e-3);
}

TEST(GripperDescriptions, HasNoSelfContact) {
  LoadedMjcf mjcf(gripper_source("two_finger_gripper.xml"));
  for (double opening = opening_axis().position_min; opening <= opening_axis().position_max; opening += 0.001) {
    mjcf.set_joints(both(opening));
    mj_forward(mjcf.model.get(), mjcf.data.get());
    EXPECT_EQ(mjcf.data->ncon, 0) << opening;
  }
}

}  // namespace
}  // namespace mrroc::descriptions_test
