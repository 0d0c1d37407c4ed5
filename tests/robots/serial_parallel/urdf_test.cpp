#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>

#include <kdl/chainfksolverpos_recursive.hpp>

#include "robots/common/kdl_chain.hpp"
#include "robots/serial_parallel/closed_mjcf.hpp"
#include "robots/serial_parallel/fixture.hpp"

namespace mrroc::urdf_test {
namespace {

constexpr std::uint64_t kUrdfSeed = 20060104;

/// A chain of the URDF and the pose of its tip.
class UrdfChain {
 public:
  explicit UrdfChain(const std::string& tip)
      : chain_(kdl_chain(serial_parallel_source("serial_parallel.urdf"), tip)), forward_(chain_) {}

  Pose tip(std::initializer_list<double> joints) {
    KDL::JntArray array(static_cast<unsigned>(joints.size()));
    std::copy(joints.begin(), joints.end(), array.data.data());
    KDL::Frame frame;
    if (forward_.JntToCart(array, frame) < 0) throw std::runtime_error("another number of joints");
    return pose_of(frame);
  }

 private:
  KDL::Chain chain_;
  KDL::ChainFkSolverPos_recursive forward_;
};

// with the model's passive angles in the URDF's joints the tool has the pose of the model, and the loops close
TEST(SerialParallelUrdf, TreeWithTheModelsPassiveAnglesIsTheMachine) {
  UrdfChain tool("tool_frame"), joint_b("joint_b"), joint_c("joint_c"), head_b("head_b"), head_c("head_c");
  std::mt19937_64 random(kUrdfSeed);
  double worst_pose = 0, worst_loop = 0, worst_hinge = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector q = random_posture(random);
    const serial_parallel::Placement placement = placement_of(q);
    const serial_parallel::PassiveAngles angles = tripod().passive_angles(placement);
    const double swing = placement.swing, tilt_a = placement.tilt - angles.lean_a;
    const Pose tip = tool.tip({swing, angles.lean_a, q[0], tilt_a, q[3], q[4], q[5]});
    worst_pose = std::max(worst_pose, pose_difference(tip, machine().flange(q) * machine().default_tool()));
    const Pose at_b = joint_b.tip({swing, angles.lean_a, q[0], tilt_a});
    const Pose at_c = joint_c.tip({swing, angles.lean_a, q[0], tilt_a});
    const Pose b = head_b.tip({angles.pitch_b, angles.lean_b, q[1]}), c = head_c.tip({swing, angles.lean_c, q[2]});
    worst_loop = std::max(
        {worst_loop, (b.translation() - at_b.translation()).norm(), (c.translation() - at_c.translation()).norm()});
    worst_hinge = std::max({worst_hinge, std::abs(b.linear().col(2).dot(at_b.linear().col(1))),
                            (c.linear().col(0) - at_c.linear().col(0)).norm()});
  }
  std::printf("seed %llu, worst of 10000: URDF by KDL %.1e m or rad, loops %.1e m, hinges %.1e rad\n",
              static_cast<unsigned long long>(kUrdfSeed), worst_pose, worst_loop, worst_hinge);
  EXPECT_LT(worst_pose, 1e-9);
  EXPECT_LT(worst_loop, 1e-9);
  EXPECT_LT(worst_hinge, 1e-9);
}

TEST(SerialParallelUrdf, JointsHaveTheLimitsOfTheParameterFile) {
  const auto urdf = urdf::parseURDFFile(serial_parallel_source("serial_parallel.urdf").string());
  ASSERT_TRUE(urdf);
  for (const AxisParameters& axis : machine().parameters().axes) {
    const auto joint = urdf->getJoint(axis.name);
    ASSERT_TRUE(joint) << axis.name;
    EXPECT_EQ(joint->limits->lower, axis.position_min) << axis.name;
    EXPECT_EQ(joint->limits->upper, axis.position_max) << axis.name;
    EXPECT_EQ(joint->limits->velocity, axis.velocity_max) << axis.name;
  }
  const serial_parallel::PassiveLimits& limits = geometry().limits;
  for (const auto& [name, lower, upper] : {std::tuple{"lean_a", -limits.ac_lean_max, limits.ac_lean_max},
                                           {"lean_b", -limits.b_lean_max, limits.b_lean_max},
                                           {"lean_c", -limits.ac_lean_max, limits.ac_lean_max}}) {
    EXPECT_EQ(urdf->getJoint(name)->limits->lower, lower) << name;
    EXPECT_EQ(urdf->getJoint(name)->limits->upper, upper) << name;
  }
  EXPECT_EQ(urdf->getJoint("pitch_b")->limits->lower, limits.b_pitch_min);
}

// leg B hangs from the platform in the MJCF and stands on the base in the URDF: the same parts, from opposite ends
TEST(SerialParallelUrdf, PartsHaveEqualMassesInUrdfAndMjcf) {
  const ClosedMjcf mjcf;
  const auto urdf = urdf::parseURDFFile(serial_parallel_source("serial_parallel.urdf").string());
  ASSERT_TRUE(urdf);
  double urdf_mass = 0;
  for (const auto& [name, link] : urdf->links_) {
    if (!link->inertial) continue;
    const urdf::Inertial& part = *link->inertial;
    const int body = mj_name2id(mjcf.model.get(), mjOBJ_BODY, name.c_str());
    ASSERT_GE(body, 0) << name;
    urdf_mass += part.mass;
    EXPECT_EQ(mjcf.model->body_mass[body], part.mass) << name;
    const Eigen::Vector3d centre(part.origin.position.x, part.origin.position.y, part.origin.position.z);
    const Eigen::Vector3d mjcf_centre = Eigen::Map<const Eigen::Vector3d>(mjcf.model->body_ipos + 3 * body);
    const bool turned = name == "leg_b" || name == "rod_b";
    EXPECT_LT((centre - (turned ? -1 : 1) * mjcf_centre).norm(), 1e-12) << name;
    const Eigen::Vector3d inertia(part.ixx, part.iyy, part.izz);
    EXPECT_EQ(inertia, Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(mjcf.model->body_inertia + 3 * body))) << name;
  }
  const int machine_body = mj_name2id(mjcf.model.get(), mjOBJ_BODY, "tripod");
  EXPECT_NEAR(urdf_mass, mjcf.model->body_subtreemass[machine_body], 1e-12) << "every part";
}

}  // namespace
}  // namespace mrroc::urdf_test
