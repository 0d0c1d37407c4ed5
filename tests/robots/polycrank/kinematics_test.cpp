#include <gtest/gtest.h>

#include "robots/polycrank/polycrank_cases.hpp"

namespace mrroc::kinematics_test {
namespace {

struct TableRow {
  double d, a, alpha;
};

/// The lab's table from its model of the robot, mm and deg, multiplied link by link.
Pose denavit_hartenberg(const JointVector& joints) {
  constexpr std::array<TableRow, 7> kTable{
      {{220, -299, 0}, {152, 180, 0}, {335, 0, 90}, {120, 151, 0}, {116, 151, 0}, {60, 0, 90}, {43, 0, 0}}};
  Pose pose = Pose::Identity();
  pose.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // the first axis along the base's x, the table's x along y
  for (int i = 0; i < 7; ++i) {
    const TableRow& row = kTable[static_cast<std::size_t>(i)];
    pose = pose * Eigen::AngleAxisd(joints[i], Eigen::Vector3d::UnitZ()) *
           Eigen::Translation3d(row.a / 1000, 0, row.d / 1000) *
           Eigen::AngleAxisd(row.alpha * M_PI / 180, Eigen::Vector3d::UnitX());
  }
  return pose;
}

TEST(PolycrankKinematics, ClosedFormEqualsTheDenavitHartenbergTable) {
  constexpr std::uint64_t kSeed = 20110113;
  std::mt19937_64 random(kSeed);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector joints = random_joints(random);
    worst = std::max(worst, pose_difference(polycrank_model().flange(joints), denavit_hartenberg(joints)));
  }
  std::printf("seed %llu, worst of 10000 poses: %.1e m or rad\n", static_cast<unsigned long long>(kSeed), worst);
  EXPECT_LT(worst, 1e-12);
}

// with all joints zero the tip is at (0.183, -0.296, 0.664) in the table's first frame
TEST(PolycrankKinematics, IsStretchedAtZero) {
  const Eigen::Vector3d tip = polycrank_model().flange(JointVector::Zero(7)).translation();
  EXPECT_LT((tip - Eigen::Vector3d(0.664, 0.183, -0.296)).norm(), 1e-12);
}

TEST(PolycrankKinematics, InverseOfFlangeIsAFixedPoint) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_joints();
    RC_PRE(dexterity(joints) > 1e-3);
    JointVector back;
    RC_ASSERT(polycrank_model().inverse(polycrank_model().flange(joints), joints, back) == ErrorCode::none);
    RC_ASSERT((back - joints).cwiseAbs().maxCoeff() < 1e-9);
  }));
}

TEST(PolycrankKinematics, InverseReachesThePoseFromAnyStart) {
  constexpr std::uint64_t kSeed = 20110114;
  std::mt19937_64 random(kSeed);
  double worst = 0, worst_fixed_point = 0;
  for (int i = 0; i < 10000; ++i) {
    const JointVector joints = random_joints(random), near = random_joints(random);
    const Pose pose = polycrank_model().flange(joints);
    JointVector found, back;
    ASSERT_EQ(polycrank_model().inverse(pose, near, found), ErrorCode::none) << joints.transpose();
    ASSERT_EQ(polycrank_model().inverse(pose, joints, back), ErrorCode::none) << joints.transpose();
    worst = std::max(worst, pose_difference(polycrank_model().flange(found), pose));
    worst_fixed_point = std::max(worst_fixed_point, (back - joints).cwiseAbs().maxCoeff());
  }
  std::printf("seed %llu, worst of 10000: pose from anywhere %.1e m or rad, fixed point %.1e rad\n",
              static_cast<unsigned long long>(kSeed), worst, worst_fixed_point);
  EXPECT_LT(worst, 1e-9);
  EXPECT_LT(worst_fixed_point, 1e-6);  // a stretched pair's angle is the root of a rounding error
}

TEST(PolycrankKinematics, PoseBeyondTheArmIsOutOfWorkspace) {
  const Pose home = polycrank_model().flange(polycrank_home());
  for (const Eigen::Vector3d& offset : {Eigen::Vector3d(0.2, 0, 0), {0, 0, 2}, {-0.9, 0, 0}, {0, -2, 0}}) {
    Pose pose = home;
    pose.translation() += offset;
    JointVector joints = polycrank_home();
    EXPECT_EQ(polycrank_model().inverse(pose, polycrank_home(), joints), ErrorCode::out_of_workspace)
        << offset.transpose();
    EXPECT_EQ(joints, polycrank_home()) << "unchanged";
  }
}

TEST(PolycrankKinematics, NonRigidTransformIsOutOfWorkspace) {
  const JointVector home = polycrank_home();
  Pose scaled = polycrank_model().flange(home), mirrored = scaled, broken = scaled;
  scaled.linear() *= 1.001;
  mirrored.linear().col(0) *= -1;
  broken.linear()(1, 1) = std::numeric_limits<double>::quiet_NaN();
  for (const Pose& pose : {scaled, mirrored, broken}) {
    JointVector joints;
    EXPECT_EQ(polycrank_model().inverse(pose, home, joints), ErrorCode::out_of_workspace);
  }
}

TEST(PolycrankKinematics, JacobianIsTheDerivativeOfThePose) {
  EXPECT_TRUE(rc::check([] {
    constexpr double kStep = 1e-6;
    const JointVector joints = any_joints();
    const Eigen::Vector3d offset(any_between(-0.5, 0.5), any_between(-0.5, 0.5), any_between(-0.5, 0.5));
    const Jacobian jacobian = polycrank_model().jacobian(joints, offset);
    for (int i = 0; i < 7; ++i) {
      JointVector ahead = joints, behind = joints;
      ahead[i] += kStep;
      behind[i] -= kStep;
      const Pose a = polycrank_model().flange(ahead), b = polycrank_model().flange(behind);
      const Eigen::Matrix3d spin = a.linear() * b.linear().transpose() / (2 * kStep);
      Twist twist;
      twist << (a * offset - b * offset) / (2 * kStep), (spin(2, 1) - spin(1, 2)) / 2, (spin(0, 2) - spin(2, 0)) / 2,
          (spin(1, 0) - spin(0, 1)) / 2;
      RC_ASSERT((twist - jacobian.col(i)).cwiseAbs().maxCoeff() < 1e-8);
    }
  }));
}

TEST(PolycrankKinematics, InvalidInputGivesACodeOrFiniteNumbers) {
  EXPECT_TRUE(rc::check([] {
    Pose pose = Pose::Identity();
    const bool keep_rotation = *rc::gen::arbitrary<bool>();
    for (int row = 0; row < 3; ++row) {
      for (int column = keep_rotation ? 3 : 0; column < 4; ++column) pose.matrix()(row, column) = any_garbage();
    }
    const JointVector garbage = any_garbage_joints(7);
    JointVector joints = JointVector::Zero(7);
    const ErrorCode code = polycrank_model().inverse(pose, garbage, joints);
    RC_ASSERT(joints.allFinite());
    RC_ASSERT(code == ErrorCode::out_of_workspace || (garbage.allFinite() && pose.matrix().allFinite()));
    const bool to_motors = polycrank_model().joints_to_motors(garbage, joints) == ErrorCode::none;
    const bool to_joints = polycrank_model().motors_to_joints(garbage, joints) == ErrorCode::none;
    RC_ASSERT(joints.allFinite());
    RC_ASSERT(garbage.allFinite() || !(to_motors || to_joints));
  }));
}

}  // namespace
}  // namespace mrroc::kinematics_test
