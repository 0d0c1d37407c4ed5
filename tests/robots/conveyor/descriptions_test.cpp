#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <random>

#include "robots/common/kdl_chain.hpp"
#include "robots/common/loaded_mjcf.hpp"
#include "robots/conveyor/conveyor_fixture.hpp"

namespace mrroc {
namespace {

TEST(ConveyorDescriptions, UrdfMjcfAndClosedFormPlaceTheToolEqually) {
  const KDL::Chain chain = kdl_chain(conveyor_file("urdf"), "tool_frame");
  ASSERT_EQ(chain.getNrOfJoints(), 1U);
  KDL::ChainFkSolverPos_recursive forward(chain);
  LoadedMjcf mjcf(conveyor_file("xml"));
  ASSERT_EQ(mjcf.model->nq, 1);
  std::mt19937_64 random(20120211);
  std::uniform_real_distribution<double> any_travel(-1000, 1000);
  double worst_kdl = 0, worst_mujoco = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector travel = one(any_travel(random));
    const Pose pose = conveyor_model()->flange(travel) * conveyor_model()->default_tool();
    KDL::JntArray joints(1);
    joints.data = travel;
    KDL::Frame frame;
    ASSERT_GE(forward.JntToCart(joints, frame), 0);
    mjcf.set_joints(travel);
    mj_kinematics(mjcf.model.get(), mjcf.data.get());
    worst_mujoco = std::max(worst_mujoco, (mjcf.site("tool").matrix() - pose.matrix()).norm());
    worst_kdl = std::max(worst_kdl, (pose_of(frame).matrix() - pose.matrix()).norm());
  }
  std::printf("worst of 10000 poses: URDF by KDL %.1e, MJCF %.1e\n", worst_kdl, worst_mujoco);
  EXPECT_LT(worst_kdl, 1e-9);
  EXPECT_LT(worst_mujoco, 1e-9);
}

TEST(ConveyorDescriptions, NamesLimitsAndMassesAreTheSame) {
  const LoadedMjcf mjcf(conveyor_file("xml"));
  const auto urdf = urdf::parseURDFFile(conveyor_file("urdf").string());
  ASSERT_TRUE(urdf);
  EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_JOINT, 0), belt().name);
  EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_ACTUATOR, 0), belt().name);
  EXPECT_FALSE(mjcf.model->jnt_limited[0]) << "endless";
  const auto joint = urdf->getJoint(belt().name);
  ASSERT_TRUE(joint);
  EXPECT_EQ(joint->limits->velocity, belt().velocity_max);
  EXPECT_GE(joint->limits->upper, 1e6) << "URDF has no unlimited slide";
  EXPECT_LE(joint->limits->lower, -1e6);
  const double gear = conveyor_model()->transmission(one(0))(0, 0);
  EXPECT_NEAR(joint->limits->effort, belt().current_max * belt().torque_constant * gear, 1);
  const int body = mj_name2id(mjcf.model.get(), mjOBJ_BODY, "belt");
  EXPECT_EQ(urdf->getLink("belt")->inertial->mass, mjcf.model->body_mass[body]);
}

TEST(ConveyorDescriptions, ArmatureAndDampingAreThoseOfTheDriveAtTheBelt) {
  const LoadedMjcf mjcf(conveyor_file("xml"));
  const double gear = conveyor_model()->transmission(one(0))(0, 0);
  EXPECT_NEAR(mjcf.model->dof_armature[0], gear * gear * belt().rotor_inertia, 1e-9);
  EXPECT_NEAR(mjcf.model->dof_damping[0], gear * gear * belt().viscous_friction, 1e-9);
}

TEST(ConveyorDescriptions, BeltTouchesNothingAndItsTopIsInTheBaseFrame) {
  LoadedMjcf mjcf(conveyor_file("xml"));
  mj_forward(mjcf.model.get(), mjcf.data.get());
  EXPECT_EQ(mjcf.data->ncon, 0);
  for (const auto& [geom, lowest] : {std::pair{"belt", -0.01}, {"foot_1", -0.55}}) {
    const int id = mj_name2id(mjcf.model.get(), mjOBJ_GEOM, geom);
    ASSERT_GE(id, 0);
    const int thickness = mjcf.model->geom_type[id] == mjGEOM_BOX ? 2 : 1;
    EXPECT_NEAR(mjcf.data->geom_xpos[3 * id + 2] - mjcf.model->geom_size[3 * id + thickness], lowest, 1e-12) << geom;
  }
}

}  // namespace
}  // namespace mrroc
