#include <gtest/gtest.h>

#include "mrroc/tool_kinematics.hpp"
#include "robots/serial_parallel/closed_mjcf.hpp"
#include "robots/serial_parallel/fixture.hpp"

namespace mrroc::mjcf_test {
namespace {

constexpr std::uint64_t kMjcfSeed = 20060104;

TEST(SerialParallelMjcf, InitialStateIsHomeWithTheLoopsClosed) {
  ClosedMjcf mjcf;
  mj_fwdPosition(mjcf.model.get(), mjcf.data.get());
  EXPECT_LT(mjcf.residual(), 1e-15);
  const JointVector home = machine().parameters().home;
  for (int i = 0; i < 3; ++i) {
    const int joint = mj_name2id(mjcf.model.get(), mjOBJ_JOINT,
                                 machine().parameters().axes[static_cast<std::size_t>(i)].name.c_str());
    EXPECT_EQ(mjcf.data->qpos[mjcf.model->jnt_qposadr[joint]], home[i]) << i;
  }
  ASSERT_TRUE(mjcf.close(home));
  EXPECT_LT(pose_difference(mjcf.site("tool"), machine().flange(home) * machine().default_tool()), 1e-12);
}

// MuJoCo closes the loops on its own: an independent direct kinematics
TEST(SerialParallelMjcf, ClosedLoopsPlaceTheToolAtThePoseOfTheModel) {
  ClosedMjcf mjcf;
  const Pose tool = machine().default_tool();
  std::mt19937_64 random(kMjcfSeed);
  double worst_pose = 0, worst_jacobian = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector joints = random_posture(random);
    mjcf.reset();
    ASSERT_TRUE(mjcf.close(joints)) << joints.transpose();
    worst_pose = std::max(worst_pose, pose_difference(mjcf.site("tool"), machine().flange(joints) * tool));
    worst_jacobian = std::max(
        worst_jacobian, (mjcf.tool_jacobian() - machine().jacobian(joints, tool.translation())).cwiseAbs().maxCoeff());
  }
  std::printf("seed %llu, worst of 10000: pose %.1e m or rad, Jacobian %.1e\n",
              static_cast<unsigned long long>(kMjcfSeed), worst_pose, worst_jacobian);
  EXPECT_LT(worst_pose, 1e-9);
  EXPECT_LT(worst_jacobian, 1e-9);
}

TEST(SerialParallelMjcf, AxesHaveTheNamesAndLimitsOfTheParameterFile) {
  const ClosedMjcf mjcf;
  const auto& axes = machine().parameters().axes;
  ASSERT_EQ(mjcf.model->nu, 6);
  for (int i = 0; i < 6; ++i) {
    const AxisParameters& axis = axes[static_cast<std::size_t>(i)];
    const int joint = mj_name2id(mjcf.model.get(), mjOBJ_JOINT, axis.name.c_str());
    ASSERT_GE(joint, 0) << axis.name;
    EXPECT_EQ(mj_id2name(mjcf.model.get(), mjOBJ_ACTUATOR, i), axis.name);
    EXPECT_EQ(mjcf.model->actuator_trnid[2 * i], joint);
    EXPECT_TRUE(mjcf.model->jnt_limited[joint]);
    const double margin = i < 3 ? 0.003 : 0;  // the legs reach their switches beyond the limits
    EXPECT_NEAR(mjcf.model->jnt_range[2 * joint], axis.position_min - margin, 1e-12) << axis.name;
    EXPECT_NEAR(mjcf.model->jnt_range[2 * joint + 1], axis.position_max + margin, 1e-12) << axis.name;
  }
}

TEST(SerialParallelMjcf, ArmatureAndDampingAreThoseOfTheDrives) {
  const ClosedMjcf mjcf;
  for (int i = 0; i < 6; ++i) {
    const AxisParameters& axis = machine().parameters().axes[static_cast<std::size_t>(i)];
    const int dof = mjcf.model->jnt_dofadr[mj_name2id(mjcf.model.get(), mjOBJ_JOINT, axis.name.c_str())];
    const double gear = geometry().gears[i];
    EXPECT_NEAR(mjcf.model->dof_armature[dof] / (gear * gear * axis.rotor_inertia), 1, 0.001) << axis.name;
    EXPECT_NEAR(mjcf.model->dof_damping[dof] / (gear * gear * axis.viscous_friction), 1, 0.005) << axis.name;
  }
}

TEST(SerialParallelMjcf, DrivesHoldTheMachineInEveryPostureAlsoAtFullSpeed) {
  ClosedMjcf mjcf;
  std::mt19937_64 random(kMjcfSeed);
  const JointVector gears = geometry().gears.cwiseAbs();
  const JointVector friction = per_axis(&AxisParameters::viscous_friction).cwiseProduct(gears);
  JointVector worst = JointVector::Zero(6);
  for (int i = 0; i < 5000; ++i) {
    mjcf.reset();
    ASSERT_TRUE(mjcf.close(random_posture(random)));
    worst = worst.cwiseMax(mjcf.holding_forces().cwiseAbs());
  }
  const JointVector amperes_per_force = gears.cwiseProduct(per_axis(&AxisParameters::torque_constant)).cwiseInverse();
  const JointVector holding = worst.cwiseProduct(amperes_per_force);
  const JointVector moving = holding + friction.cwiseProduct(per_axis(&AxisParameters::velocity_max))
                                           .cwiseQuotient(per_axis(&AxisParameters::torque_constant));
  std::printf("seed %llu, worst of 5000: legs %.0f %.0f %.0f N, wrist %.1f %.1f %.1f N m\n",
              static_cast<unsigned long long>(kMjcfSeed), worst[0], worst[1], worst[2], worst[3], worst[4], worst[5]);
  std::printf("current: %.2f %.2f %.2f %.2f %.2f %.2f A; at full speed %.2f %.2f %.2f %.2f %.2f %.2f A\n", holding[0],
              holding[1], holding[2], holding[3], holding[4], holding[5], moving[0], moving[1], moving[2], moving[3],
              moving[4], moving[5]);
  EXPECT_GT(worst.head<3>().maxCoeff(), 20) << "the machine has weight";
  EXPECT_LT(holding.cwiseQuotient(per_axis(&AxisParameters::current_max)).maxCoeff(), 0.3);
  EXPECT_LT(moving.cwiseQuotient(per_axis(&AxisParameters::current_max)).maxCoeff(), 0.7);
}

/// Whether the posture's tool is above the bed and beside the posts, which no joint limit ensures.
bool clear_of_the_portal(const Pose& tip) {
  const Eigen::Vector3d p = tip.translation();
  return p.z() > -0.57 && std::abs(p.y()) < 0.3;
}

TEST(SerialParallelMjcf, MachineDoesNotTouchItselfAboveItsBed) {
  ClosedMjcf mjcf;
  std::mt19937_64 random(kMjcfSeed);
  int checked = 0;
  for (int i = 0; i < 4000; ++i) {
    const JointVector posture = i == 0 ? machine().parameters().home : random_posture(random);
    if (!clear_of_the_portal(machine().flange(posture) * machine().default_tool())) continue;
    mjcf.reset();
    ASSERT_TRUE(mjcf.close(posture));
    ASSERT_EQ(mjcf.data->ncon, 0) << posture.transpose() << ": "
                                  << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom1) << " and "
                                  << mj_id2name(mjcf.model.get(), mjOBJ_GEOM, mjcf.data->contact[0].geom2);
    ++checked;
  }
  EXPECT_GT(checked, 2000);
}

TEST(SerialParallelMjcf, PortalStandsOnTheFloorBelowTheBaseFrame) {
  ClosedMjcf mjcf;
  mj_kinematics(mjcf.model.get(), mjcf.data.get());
  const int bed = mj_name2id(mjcf.model.get(), mjOBJ_GEOM, "bed");
  ASSERT_GE(bed, 0);
  EXPECT_NEAR(mjcf.data->geom_xpos[3 * bed + 2] - mjcf.model->geom_size[3 * bed + 2], -0.6, 1e-12);
}

TEST(SerialParallelMjcf, WristSiteIsTheFlangeOnTheBodyThatCarriesTheTool) {
  ClosedMjcf mjcf;
  const int wrist = mj_name2id(mjcf.model.get(), mjOBJ_SITE, "wrist"),
            tool = mj_name2id(mjcf.model.get(), mjOBJ_SITE, "tool");
  const int body = mj_name2id(mjcf.model.get(), mjOBJ_BODY, "tool");
  ASSERT_GE(body, 0);
  EXPECT_EQ(mjcf.model->site_bodyid[wrist], body);
  EXPECT_EQ(mjcf.model->site_bodyid[tool], body);
  EXPECT_EQ(mjcf.model->body_jntnum[body], 0) << "welded, so that the sensor measures all of it";
  const JointVector home = machine().parameters().home;
  ASSERT_TRUE(mjcf.close(home));
  EXPECT_LT(pose_difference(mjcf.site("wrist"), machine().flange(home)), 1e-12);
}

}  // namespace
}  // namespace mrroc::mjcf_test
