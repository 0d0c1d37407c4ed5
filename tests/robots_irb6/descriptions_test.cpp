#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/frames_io.hpp>

#include "irb6_fixture.hpp"
#include "robots_irb6/kdl_chain.hpp"
#include "robots_irb6/mjcf.hpp"

namespace mrroc {
namespace {

constexpr std::uint64_t kSeed = 20060104;

KDL::JntArray kdl_joints(const JointVector& joints) {
  KDL::JntArray array(6);
  array.data = joints;
  return array;
}

Pose pose_of(const KDL::Frame& frame) {
  Pose pose = Pose::Identity();
  pose.translation() << frame.p.x(), frame.p.y(), frame.p.z();
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.M.data);
  return pose;
}

TEST(Irb6Descriptions, UrdfMjcfAndClosedFormPlaceTheToolAlike) {
  const KDL::Chain chain = kdl_chain(irb6_source("irb6.urdf"), "tool_frame");
  ASSERT_EQ(chain.getNrOfJoints(), 6u);
  KDL::ChainFkSolverPos_recursive forward(chain);
  KDL::ChainJntToJacSolver jacobian_solver(chain);
  Mjcf mjcf(irb6_source("irb6.xml"));
  ASSERT_EQ(mjcf.model->nq, 6);
  std::mt19937_64 random(kSeed);
  double worst_kdl = 0, worst_mujoco = 0, worst_jacobian = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector joints = random_joints(random);
    const Pose pose = irb6_kinematics().direct(joints);
    KDL::Frame frame;
    ASSERT_GE(forward.JntToCart(kdl_joints(joints), frame), 0);
    KDL::Jacobian jacobian(6);
    ASSERT_GE(jacobian_solver.JntToJac(kdl_joints(joints), jacobian), 0);
    mjcf.set_joints(joints);
    mj_kinematics(mjcf.model.get(), mjcf.data.get());
    worst_kdl = std::max(worst_kdl, pose_difference(pose, pose_of(frame)));
    worst_mujoco = std::max(worst_mujoco, pose_difference(pose, mjcf.site("tool")));
    worst_jacobian =
        std::max(worst_jacobian, (irb6_kinematics().jacobian(joints) - jacobian.data).cwiseAbs().maxCoeff());
  }
  std::printf("seed %llu, worst of 10000 poses: URDF by KDL %.1e, MJCF %.1e m or rad, Jacobian %.1e\n",
              static_cast<unsigned long long>(kSeed), worst_kdl, worst_mujoco, worst_jacobian);
  EXPECT_LT(worst_kdl, 1e-9);
  EXPECT_LT(worst_mujoco, 1e-9);
  EXPECT_LT(worst_jacobian, 1e-9);
}

TEST(Irb6Descriptions, UrdfAndMjcfHaveTheSameMasses) {
  const KDL::Chain chain = kdl_chain(irb6_source("irb6.urdf"), "tool_frame");
  KDL::ChainDynParam dynamics(chain, KDL::Vector(0, 0, -9.81));
  Mjcf mjcf(irb6_source("irb6.xml"));
  ASSERT_EQ(mjcf.model->opt.gravity[2], -9.81);
  std::mt19937_64 random(kSeed);
  double worst_gravity = 0, worst_mass = 0;
  for (int i = 0; i < 1000; ++i) {
    const JointVector joints = random_joints(random);
    KDL::JntArray gravity(6);
    KDL::JntSpaceInertiaMatrix mass(6);
    ASSERT_GE(dynamics.JntToGravity(kdl_joints(joints), gravity), 0);
    ASSERT_GE(dynamics.JntToMass(kdl_joints(joints), mass), 0);
    mjcf.set_joints(joints);
    mj_forward(mjcf.model.get(), mjcf.data.get());
    JointMatrix bare = mjcf.mass_matrix();
    for (int axis = 0; axis < 6; ++axis) {
      worst_gravity =
          std::max(worst_gravity, std::abs(gravity(static_cast<unsigned>(axis)) - mjcf.data->qfrc_bias[axis]));
      bare(axis, axis) -= mjcf.model->dof_armature[axis];
    }
    worst_mass = std::max(worst_mass, (bare - mass.data).cwiseAbs().maxCoeff());
  }
  std::printf("worst of 1000: gravity %.1e N m, inertia %.1e kg m^2\n", worst_gravity, worst_mass);
  EXPECT_LT(worst_gravity, 1e-9);
  EXPECT_LT(worst_mass, 1e-9);
}

TEST(Irb6Descriptions, AxesHaveTheNamesAndLimitsOfTheParameterFile) {
  const Mjcf mjcf(irb6_source("irb6.xml"));
  const auto urdf = urdf::parseURDFFile(irb6_source("irb6.urdf").string());
  ASSERT_TRUE(urdf);
  const auto& axes = irb6_model().parameters().axes;
  ASSERT_EQ(mjcf.model->njnt, 6);
  ASSERT_EQ(mjcf.model->nu, 6);
  for (int i = 0; i < 6; ++i) {
    const AxisParameters& axis = axes[static_cast<std::size_t>(i)];
    EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_JOINT, i), axis.name);
    EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_ACTUATOR, i), axis.name);
    EXPECT_EQ(mjcf.model->actuator_trnid[2 * i], i);
    EXPECT_TRUE(mjcf.model->jnt_limited[i]);
    EXPECT_EQ(mjcf.model->jnt_range[2 * i], axis.position_min) << axis.name;
    EXPECT_EQ(mjcf.model->jnt_range[2 * i + 1], axis.position_max) << axis.name;
    const auto joint = urdf->getJoint(axis.name);
    ASSERT_TRUE(joint) << axis.name;
    EXPECT_EQ(joint->limits->lower, axis.position_min) << axis.name;
    EXPECT_EQ(joint->limits->upper, axis.position_max) << axis.name;
    EXPECT_EQ(joint->limits->velocity, axis.velocity_max) << axis.name;
  }
}

TEST(Irb6Descriptions, ArmatureAndDampingAreTheDrivesSeenFromTheJointsAtHome) {
  const Mjcf mjcf(irb6_source("irb6.xml"));
  const JointMatrix g = irb6_model().transmission(irb6_model().parameters().home);
  const JointMatrix inertia = g.transpose() * per_axis(&AxisParameters::rotor_inertia).asDiagonal() * g;
  const JointMatrix friction = g.transpose() * per_axis(&AxisParameters::viscous_friction).asDiagonal() * g;
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(mjcf.model->dof_armature[i] / inertia(i, i), 1, 0.001) << i;
    EXPECT_NEAR(mjcf.model->dof_damping[i] / friction(i, i), 1, 0.005) << i;
  }
}

TEST(Irb6Descriptions, TheArmDoesNotTouchItselfOrItsPost) {
  Mjcf mjcf(irb6_source("irb6.xml"));
  std::vector<JointVector> postures{irb6_model().parameters().home};
  JointVector synchro;
  ASSERT_EQ(irb6_model().motors_to_joints(per_axis(&AxisParameters::motor_synchro), synchro), ErrorCode::none);
  postures.push_back(synchro);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 2000; ++i) postures.push_back(random_posture(random));
  for (const JointVector& posture : postures) {
    mjcf.set_joints(posture);
    mj_forward(mjcf.model.get(), mjcf.data.get());
    ASSERT_EQ(mjcf.data->ncon, 0) << posture.transpose() << ": "
                                  << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom1) << " and "
                                  << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom2);
  }
}

TEST(Irb6Descriptions, ThePostStandsOnTheFloorBelowTheBaseFrame) {
  Mjcf mjcf(irb6_source("irb6.xml"));
  mj_kinematics(mjcf.model.get(), mjcf.data.get());
  const int foot = mj_name2id(mjcf.model.get(), mjOBJ_GEOM, "foot");
  ASSERT_GE(foot, 0);
  EXPECT_NEAR(mjcf.data->geom_xpos[3 * foot + 2] - mjcf.model->geom_size[3 * foot + 2], -0.7, 1e-12);
}

TEST(Irb6Descriptions, TheWristSiteIsOnTheBodyThatCarriesTheTool) {
  Mjcf mjcf(irb6_source("irb6.xml"));
  const int wrist = mj_name2id(mjcf.model.get(), mjOBJ_SITE, "wrist"),
            tool = mj_name2id(mjcf.model.get(), mjOBJ_SITE, "tool");
  const int body = mj_name2id(mjcf.model.get(), mjOBJ_BODY, "tool");
  ASSERT_GE(body, 0);
  EXPECT_EQ(mjcf.model->site_bodyid[wrist], body);
  EXPECT_EQ(mjcf.model->site_bodyid[tool], body);
  EXPECT_EQ(mjcf.model->body_jntnum[body], 0) << "welded, so that the sensor measures all of it";
}

}  // namespace
}  // namespace mrroc
