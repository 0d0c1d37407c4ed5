#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/frames_io.hpp>

#include "robots/common/kdl_chain.hpp"
#include "robots/common/mjcf.hpp"
#include "robots/polycrank/polycrank_fixture.hpp"

namespace mrroc::descriptions_test {
namespace {

constexpr std::uint64_t kDescriptionSeed = 20110118;

KDL::JntArray kdl_joints(const JointVector& joints) {
  KDL::JntArray array(7);
  array.data = joints;
  return array;
}

TEST(PolycrankDescriptions, UrdfMjcfAndClosedFormPlaceTheToolEqually) {
  const KDL::Chain chain = kdl_chain(polycrank_source("polycrank.urdf"), "tool_frame");
  ASSERT_EQ(chain.getNrOfJoints(), 7u);
  KDL::ChainFkSolverPos_recursive forward(chain);
  KDL::ChainJntToJacSolver jacobian_solver(chain);
  Mjcf mjcf(polycrank_source("polycrank.xml"));
  ASSERT_EQ(mjcf.model->nq, 7);
  const ToolKinematics kinematics(polycrank_model());
  std::mt19937_64 random(kDescriptionSeed);
  double worst_kdl = 0, worst_mujoco = 0, worst_jacobian = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector joints = random_joints(random);
    const Pose pose = kinematics.direct(joints);
    KDL::Frame frame;
    ASSERT_GE(forward.JntToCart(kdl_joints(joints), frame), 0);
    KDL::Jacobian jacobian(7);
    ASSERT_GE(jacobian_solver.JntToJac(kdl_joints(joints), jacobian), 0);
    mjcf.set_joints(joints);
    mj_kinematics(mjcf.model.get(), mjcf.data.get());
    worst_kdl = std::max(worst_kdl, pose_difference(pose, pose_of(frame)));
    worst_mujoco = std::max(worst_mujoco, pose_difference(pose, mjcf.site("tool")));
    worst_jacobian = std::max(worst_jacobian, (kinematics.jacobian(joints) - jacobian.data).cwiseAbs().maxCoeff());
  }
  std::printf("seed %llu, worst of 10000 poses: URDF by KDL %.1e, MJCF %.1e m or rad, Jacobian %.1e\n",
              static_cast<unsigned long long>(kDescriptionSeed), worst_kdl, worst_mujoco, worst_jacobian);
  EXPECT_LT(worst_kdl, 1e-9);
  EXPECT_LT(worst_mujoco, 1e-9);
  EXPECT_LT(worst_jacobian, 1e-9);
}

TEST(PolycrankDescriptions, UrdfAndMjcfHaveTheSameMasses) {
  const KDL::Chain chain = kdl_chain(polycrank_source("polycrank.urdf"), "tool_frame");
  KDL::ChainDynParam dynamics(chain, KDL::Vector(0, 0, -9.81));
  Mjcf mjcf(polycrank_source("polycrank.xml"));
  ASSERT_EQ(mjcf.model->opt.gravity[2], -9.81);
  std::mt19937_64 random(kDescriptionSeed);
  double worst_gravity = 0, worst_mass = 0;
  for (int i = 0; i < 1000; ++i) {
    const JointVector joints = random_joints(random);
    KDL::JntArray gravity(7);
    KDL::JntSpaceInertiaMatrix mass(7);
    ASSERT_GE(dynamics.JntToGravity(kdl_joints(joints), gravity), 0);
    ASSERT_GE(dynamics.JntToMass(kdl_joints(joints), mass), 0);
    mjcf.set_joints(joints);
    mj_forward(mjcf.model.get(), mjcf.data.get());
    JointMatrix bare = mjcf.mass_matrix();
    for (int axis = 0; axis < 7; ++axis) {
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

TEST(PolycrankDescriptions, AxesHaveTheNamesOfTheParameterFileAndNoLimits) {
  const Mjcf mjcf(polycrank_source("polycrank.xml"));
  const auto urdf = urdf::parseURDFFile(polycrank_source("polycrank.urdf").string());
  ASSERT_TRUE(urdf);
  const auto& axes = polycrank_model().parameters().axes;
  const JointMatrix g = polycrank_model().transmission(polycrank_home());
  ASSERT_EQ(mjcf.model->njnt, 7);
  ASSERT_EQ(mjcf.model->nu, 7);
  for (int i = 0; i < 7; ++i) {
    const AxisParameters& axis = axes[static_cast<std::size_t>(i)];
    EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_JOINT, i), axis.name);
    EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_ACTUATOR, i), axis.name);
    EXPECT_EQ(mjcf.model->actuator_trnid[2 * i], i);
    EXPECT_FALSE(mjcf.model->jnt_limited[i]) << axis.name;
    const auto joint = urdf->getJoint(axis.name);
    ASSERT_TRUE(joint) << axis.name;
    EXPECT_EQ(joint->type, urdf::Joint::CONTINUOUS) << axis.name;
    EXPECT_EQ(joint->limits->velocity, axis.velocity_max) << axis.name;
    EXPECT_NEAR(joint->limits->effort, axis.current_max * axis.torque_constant * g(i, i), 1e-9) << axis.name;
  }
}

TEST(PolycrankDescriptions, ArmatureAndDampingAreThoseOfTheDrives) {
  const Mjcf mjcf(polycrank_source("polycrank.xml"));
  const JointVector gears = polycrank_model().transmission(polycrank_home()).diagonal();
  const JointVector inertia = gears.cwiseAbs2().cwiseProduct(per_axis(&AxisParameters::rotor_inertia));
  const JointVector friction = gears.cwiseAbs2().cwiseProduct(per_axis(&AxisParameters::viscous_friction));
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(mjcf.model->dof_armature[i], inertia[i], 1e-9) << i;
    EXPECT_NEAR(mjcf.model->dof_damping[i], friction[i], 1e-9) << i;
  }
}

// the purpose of the offsets along the axes
TEST(PolycrankDescriptions, CranksDoNotTouchInAnyPosture) {
  Mjcf mjcf(polycrank_source("polycrank.xml"));
  std::mt19937_64 random(kDescriptionSeed);
  std::uniform_int_distribution<int> quarter(-2, 2);
  for (int i = 0; i < 20000; ++i) {
    JointVector posture = random_joints(random, 0.5);
    // every other posture is one of the corners, where cranks are parallel and side by side
    if (i % 2 == 0) posture = posture.unaryExpr([&](double) { return quarter(random) * M_PI / 2; });
    mjcf.set_joints(i == 0 ? polycrank_home() : posture);
    mj_forward(mjcf.model.get(), mjcf.data.get());
    ASSERT_EQ(mjcf.data->ncon, 0) << posture.transpose() << ": "
                                  << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom1) << " and "
                                  << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom2);
  }
}

TEST(PolycrankDescriptions, StandReachesTheFloorBelowTheBaseFrame) {
  Mjcf mjcf(polycrank_source("polycrank.xml"));
  mj_kinematics(mjcf.model.get(), mjcf.data.get());
  const int foot = mj_name2id(mjcf.model.get(), mjOBJ_GEOM, "foot");
  ASSERT_GE(foot, 0);
  EXPECT_NEAR(mjcf.data->geom_xpos[3 * foot + 2] - mjcf.model->geom_size[3 * foot + 2], -0.925, 1e-12);
}

TEST(PolycrankDescriptions, WristSiteIsOnTheBodyThatCarriesTheTool) {
  Mjcf mjcf(polycrank_source("polycrank.xml"));
  const int wrist = mj_name2id(mjcf.model.get(), mjOBJ_SITE, "wrist"),
            tool = mj_name2id(mjcf.model.get(), mjOBJ_SITE, "tool");
  const int body = mj_name2id(mjcf.model.get(), mjOBJ_BODY, "tool");
  ASSERT_GE(body, 0);
  EXPECT_EQ(mjcf.model->site_bodyid[wrist], body);
  EXPECT_EQ(mjcf.model->site_bodyid[tool], body);
  EXPECT_EQ(mjcf.model->body_jntnum[body], 0) << "welded, so that the sensor measures all of it";
}

}  // namespace
}  // namespace mrroc::descriptions_test
