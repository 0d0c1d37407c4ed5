#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/frames_io.hpp>

#include "config/table.hpp"
#include "robots/common/kdl_chain.hpp"
#include "robots/common/mjcf.hpp"
#include "robots/irb6/family/robot_under_test.hpp"

namespace mrroc {
namespace {

constexpr std::uint64_t kDescriptionSeed = 20060104;

KDL::JntArray kdl_joints(const JointVector& joints) {
  KDL::JntArray array(static_cast<unsigned>(joints.size()));
  array.data = joints;
  return array;
}

TEST(Descriptions, UrdfMjcfAndClosedFormPlaceTheToolEqually) {
  const KDL::Chain chain = kdl_chain(robot_file("urdf"), "tool_frame");
  const int axes = robot().joint_count();
  ASSERT_EQ(chain.getNrOfJoints(), static_cast<unsigned>(axes));
  KDL::ChainFkSolverPos_recursive forward(chain);
  KDL::ChainJntToJacSolver jacobian_solver(chain);
  Mjcf mjcf(robot_file("xml"));
  ASSERT_EQ(mjcf.model->nq, axes);
  std::mt19937_64 random(kDescriptionSeed);
  double worst_kdl = 0, worst_mujoco = 0, worst_jacobian = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector joints = random_joints(random);
    const Pose pose = arm().direct(joints);
    KDL::Frame frame;
    ASSERT_GE(forward.JntToCart(kdl_joints(joints), frame), 0);
    KDL::Jacobian jacobian(chain.getNrOfJoints());
    ASSERT_GE(jacobian_solver.JntToJac(kdl_joints(joints), jacobian), 0);
    mjcf.set_joints(joints);
    mj_kinematics(mjcf.model.get(), mjcf.data.get());
    worst_kdl = std::max(worst_kdl, pose_difference(pose, pose_of(frame)));
    worst_mujoco = std::max(worst_mujoco, pose_difference(pose, mjcf.site("tool")));
    worst_jacobian = std::max(worst_jacobian, (arm().jacobian(joints) - jacobian.data).cwiseAbs().maxCoeff());
  }
  std::printf("seed %llu, worst of 10000 poses: URDF by KDL %.1e, MJCF %.1e m or rad, Jacobian %.1e\n",
              static_cast<unsigned long long>(kDescriptionSeed), worst_kdl, worst_mujoco, worst_jacobian);
  EXPECT_LT(worst_kdl, 1e-9);
  EXPECT_LT(worst_mujoco, 1e-9);
  EXPECT_LT(worst_jacobian, 1e-9);
}

TEST(Descriptions, InverseOfKdlsPoseReturnsToTheJoints) {
  const KDL::Chain chain = kdl_chain(robot_file("urdf"), "tool_frame");
  KDL::ChainFkSolverPos_recursive forward(chain);
  std::mt19937_64 random(kDescriptionSeed);
  double worst = 0;
  int singular = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector joints = random_posture(random);
    KDL::Frame frame;
    ASSERT_GE(forward.JntToCart(kdl_joints(joints), frame), 0);
    for (const auto& model : robot_under_test().models) {
      if (pose_difference(model->flange(joints), robot().flange(joints)) > 1e-9) continue;  // another geometry
      JointVector back;
      const ErrorCode code = model->inverse(pose_of(frame) * robot().default_tool().inverse(), joints, back);
      if (code == ErrorCode::singular) {
        ++singular;
        continue;
      }
      ASSERT_EQ(code, ErrorCode::none) << model->name() << " " << joints.transpose();
      worst = std::max(worst, (back - joints).cwiseAbs().maxCoeff());
    }
  }
  std::printf("seed %llu, worst of 10000 postures: inverse %.1e, singular %d times\n",
              static_cast<unsigned long long>(kDescriptionSeed), worst, singular);
  EXPECT_LT(worst, 1e-9);
  EXPECT_LT(singular, 10);
}

TEST(Descriptions, UrdfAndMjcfHaveTheSameMasses) {
  const KDL::Chain chain = kdl_chain(robot_file("urdf"), "tool_frame");
  KDL::ChainDynParam dynamics(chain, KDL::Vector(0, 0, -9.81));
  Mjcf mjcf(robot_file("xml"));
  ASSERT_EQ(mjcf.model->opt.gravity[2], -9.81);
  std::mt19937_64 random(kDescriptionSeed);
  double worst_gravity = 0, worst_mass = 0;
  for (int i = 0; i < 1000; ++i) {
    const JointVector joints = random_joints(random);
    KDL::JntArray gravity(chain.getNrOfJoints());
    KDL::JntSpaceInertiaMatrix mass(chain.getNrOfJoints());
    ASSERT_GE(dynamics.JntToGravity(kdl_joints(joints), gravity), 0);
    ASSERT_GE(dynamics.JntToMass(kdl_joints(joints), mass), 0);
    mjcf.set_joints(joints);
    mj_forward(mjcf.model.get(), mjcf.data.get());
    JointMatrix bare = mjcf.mass_matrix();
    for (int axis = 0; axis < robot().joint_count(); ++axis) {
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

TEST(Descriptions, AxesHaveTheNamesAndLimitsOfTheParameterFile) {
  const Mjcf mjcf(robot_file("xml"));
  const auto urdf = urdf::parseURDFFile(robot_file("urdf").string());
  ASSERT_TRUE(urdf);
  const auto& axes = robot().parameters().axes;
  const config::Table file = config::Table::load(robot_file("toml")), description = file.table("description");
  ASSERT_EQ(mjcf.model->njnt, robot().joint_count());
  ASSERT_EQ(mjcf.model->nu, robot().joint_count());
  for (int i = 0; i < robot().joint_count(); ++i) {
    const AxisParameters& axis = axes[static_cast<std::size_t>(i)];
    EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_JOINT, i), axis.name);
    EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_ACTUATOR, i), axis.name);
    EXPECT_EQ(mjcf.model->actuator_trnid[2 * i], i);
    EXPECT_TRUE(mjcf.model->jnt_limited[i]);
    const double margin = description.number(axis.name == "track" ? "track_stop_margin" : "stop_margin");
    EXPECT_NEAR(mjcf.model->jnt_range[2 * i], axis.position_min - margin, 1e-12) << axis.name;
    EXPECT_NEAR(mjcf.model->jnt_range[2 * i + 1], axis.position_max + margin, 1e-12) << axis.name;
    const auto joint = urdf->getJoint(axis.name);
    ASSERT_TRUE(joint) << axis.name;
    EXPECT_EQ(joint->limits->lower, axis.position_min) << axis.name;
    EXPECT_EQ(joint->limits->upper, axis.position_max) << axis.name;
    EXPECT_EQ(joint->limits->velocity, axis.velocity_max) << axis.name;
  }
}

TEST(Descriptions, ArmatureAndDampingAreThoseOfTheDrivesAtHome) {
  const Mjcf mjcf(robot_file("xml"));
  const JointMatrix g = robot().transmission(robot().parameters().home);
  const JointMatrix inertia = g.transpose() * per_axis(&AxisParameters::rotor_inertia).asDiagonal() * g;
  const JointMatrix friction = g.transpose() * per_axis(&AxisParameters::viscous_friction).asDiagonal() * g;
  for (int i = 0; i < robot().joint_count(); ++i) {
    EXPECT_NEAR(mjcf.model->dof_armature[i] / inertia(i, i), 1, 0.001) << i;
    EXPECT_NEAR(mjcf.model->dof_damping[i] / friction(i, i), 1, 0.005) << i;
  }
}

}  // namespace
}  // namespace mrroc
