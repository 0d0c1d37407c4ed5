#include "robots/serial_parallel/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases.hpp"
#include "mrroc/robots/serial_parallel.hpp"
#include "mrroc/tool_kinematics.hpp"

namespace mrroc::kinematics_test {
namespace {

bool nearly_straight(const JointVector& joints) { return std::abs(std::sin(joints[4])) < 1e-4; }

TEST(SerialParallelKinematics, InverseOfTheFlangeReturnsToTheJoints) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_posture();
    RC_PRE(!nearly_straight(joints));
    JointVector back;
    RC_ASSERT(machine().inverse(machine().flange(joints), joints, back) == ErrorCode::none);
    RC_ASSERT((back - joints).cwiseAbs().maxCoeff() < 1e-9);
  }));
}

TEST(SerialParallelKinematics, DirectOfTheInverseReturnsToThePoseFromAnyStart) {
  EXPECT_TRUE(rc::check([] {
    const Pose pose = machine().flange(any_posture());
    JointVector joints;
    RC_ASSERT(machine().inverse(pose, any_posture(), joints) != ErrorCode::out_of_workspace);
    RC_ASSERT(pose_difference(machine().flange(joints), pose) < 1e-9);
  }));
}

TEST(SerialParallelKinematics, TenThousandRandomPosturesReturn) {
  constexpr std::uint64_t kSeed = 20060107;
  std::mt19937_64 random(kSeed);
  double worst_joint = 0, worst_pose = 0;
  int straight = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector joints = random_posture(random);
    const Pose pose = machine().flange(joints);
    JointVector back;
    ASSERT_NE(machine().inverse(pose, joints, back), ErrorCode::out_of_workspace);
    worst_pose = std::max(worst_pose, pose_difference(machine().flange(back), pose));
    if (nearly_straight(joints)) {
      ++straight;
    } else {
      worst_joint = std::max(worst_joint, (back - joints).cwiseAbs().maxCoeff());
    }
  }
  std::printf("seed %llu, worst of 10000 (%d nearly straight): joints %.1e rad or m, pose %.1e m or rad\n",
              static_cast<unsigned long long>(kSeed), straight, worst_joint, worst_pose);
  EXPECT_LT(worst_joint, 1e-9);
  EXPECT_LT(worst_pose, 1e-9);
}

TEST(SerialParallelKinematics, PassiveJointBeyondItsLimitIsOutOfTheWorkspace) {
  const JointVector home = machine().parameters().home;
  Pose pose = machine().flange(home);
  JointVector joints = home;
  while (machine().inverse(pose, joints, joints) == ErrorCode::none) pose.translation().y() += 1e-4;
  const serial_parallel::PassiveAngles angles = tripod().passive_angles(placement_of(joints));
  EXPECT_NEAR(std::max(std::abs(angles.lean_a), std::abs(angles.lean_c)), M_PI / 6, 1e-3);
  EXPECT_GT(pose.translation().y(), 0.15);
  EXPECT_NEAR(joints.head<3>().minCoeff(), 0.28, 0.05) << "the legs could extend further";
}

TEST(SerialParallelKinematics, InvalidOrUnreachablePoseLeavesTheJointsUnchanged) {
  const JointVector home = machine().parameters().home;
  Pose scaled = machine().flange(home), mirrored = scaled, broken = scaled, above = scaled;
  scaled.linear() *= 1.001;
  mirrored.linear().col(0) *= -1;
  broken.linear()(1, 1) = std::numeric_limits<double>::quiet_NaN();
  above.translation().z() = 0.4;
  for (const Pose& pose : {scaled, mirrored, broken, above}) {
    JointVector joints = home;
    EXPECT_EQ(machine().inverse(pose, home, joints), ErrorCode::out_of_workspace);
    EXPECT_EQ(joints, home);
  }
}

TEST(SerialParallelKinematics, JacobianIsTheDerivativeOfThePose) {
  EXPECT_TRUE(rc::check([] {
    constexpr double kStep = 1e-6;
    const JointVector joints = any_posture();
    const Eigen::Vector3d offset(any_between(-0.2, 0.2), any_between(-0.2, 0.2), any_between(-0.2, 0.2));
    const Jacobian jacobian = machine().jacobian(joints, offset);
    for (int i = 0; i < 6; ++i) {
      JointVector ahead = joints, behind = joints;
      ahead[i] += kStep;
      behind[i] -= kStep;
      const Pose a = machine().flange(ahead), b = machine().flange(behind);
      const Eigen::Matrix3d spin = a.linear() * b.linear().transpose() / (2 * kStep);
      Twist twist;
      twist << (a * offset - b * offset) / (2 * kStep), (spin(2, 1) - spin(1, 2)) / 2, (spin(0, 2) - spin(2, 0)) / 2,
          (spin(1, 0) - spin(0, 1)) / 2;
      RC_ASSERT((twist - jacobian.col(i)).cwiseAbs().maxCoeff() < 1e-6);
    }
  }));
}

TEST(SerialParallelKinematics, HomePointsTheSpindleDown) {
  const Pose tip = machine().flange(machine().parameters().home) * machine().default_tool();
  EXPECT_LT(pose_difference(tip, SerialParallel::tool_down(0, 0, -0.5305)), 1e-12);
}

TEST(SerialParallelKinematics, InvalidInputGivesACodeOrFiniteNumbers) {
  EXPECT_TRUE(rc::check([] {
    Pose pose = Pose::Identity();
    const bool keep_rotation = *rc::gen::arbitrary<bool>();
    for (int row = 0; row < 3; ++row) {
      for (int column = keep_rotation ? 3 : 0; column < 4; ++column) pose.matrix()(row, column) = any_garbage();
    }
    const JointVector near = any_garbage_joints(6);
    JointVector joints = JointVector::Zero(6);
    const ErrorCode code = machine().inverse(pose, near, joints);
    RC_ASSERT(joints.allFinite());
    RC_ASSERT(code == ErrorCode::out_of_workspace || (near.allFinite() && pose.matrix().allFinite()));
    if (near.allFinite()) {
      RC_ASSERT(machine().flange(near).matrix().allFinite());
      RC_ASSERT(machine().jacobian(near, {0, 0, 0.1}).allFinite());
    }
  }));
}

}  // namespace
}  // namespace mrroc::kinematics_test
