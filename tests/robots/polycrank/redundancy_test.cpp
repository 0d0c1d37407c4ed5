#include <gtest/gtest.h>

#include <Eigen/LU>

#include "robots/polycrank/polycrank_cases.hpp"

namespace mrroc::redundancy_test {
namespace {

JointVector inverse(const Pose& pose, const JointVector& near) {
  JointVector joints;
  RC_ASSERT(polycrank_model().inverse(pose, near, joints) == ErrorCode::none);
  return joints;
}

/// Direction of the joints while the flange is at rest; length 1.
JointVector self_motion(const JointVector& joints) {
  return Eigen::MatrixXd(flange_jacobian(joints)).fullPivLu().kernel().col(0).normalized();
}

/// Joint velocity of minimum norm for a twist of the flange.
JointVector least_norm(const JointVector& joints, const Twist& twist) {
  const Jacobian j = flange_jacobian(joints);
  return j.transpose() * Eigen::Matrix<double, 6, 6>(j * j.transpose()).inverse() * twist;
}

Pose moved(const Pose& pose, const Twist& twist, double time) {
  Pose result = pose;
  result.translation() += twist.head<3>() * time;
  const double angle = twist.tail<3>().norm() * time;
  result.linear() = Eigen::AngleAxisd(angle, twist.tail<3>().normalized()) * pose.linear();
  return result;
}

Twist any_twist() {
  Twist twist;
  for (int i = 0; i < 6; ++i) twist[i] = any_between(-1, 1);
  RC_PRE(twist.tail<3>().norm() > 1e-3);
  return twist;
}

TEST(PolycrankRedundancy, NoOtherSolutionNearbyChangesTheJointsLess) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_joints(), near = any_near(joints, 0.05);
    RC_PRE(dexterity(joints) > 0.02);
    const JointVector found = inverse(polycrank_model().flange(joints), near);
    RC_ASSERT((found - near).norm() <= (joints - near).norm() + 1e-9);
  }));
}

TEST(PolycrankRedundancy, ChangeFromNearIsOrthogonalToTheSelfMotion) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_joints(), near = any_near(joints, 0.5);
    const JointVector found = inverse(polycrank_model().flange(joints), near);
    RC_PRE(dexterity(found) > 0.02);
    RC_ASSERT(std::abs(self_motion(found).dot(found - near)) < 1e-7);
  }));
}

TEST(PolycrankRedundancy, SmallStepIsTheMinimumNormSolution) {
  EXPECT_TRUE(rc::check([] {
    constexpr double kTime = 1e-4;
    const JointVector joints = any_joints();
    RC_PRE(dexterity(joints) > 0.02);
    const Twist twist = any_twist();
    const JointVector found = inverse(moved(polycrank_model().flange(joints), twist, kTime), joints);
    const JointVector expected = least_norm(joints, twist);
    RC_ASSERT(((found - joints) / kTime - expected).norm() < 0.05 * std::max(1.0, expected.norm()));
  }));
}

// straight paths of 0.2 m with a rotation of up to 0.5 rad, from any start, while the arm is not singular
TEST(PolycrankRedundancy, PathsAreContinuous) {
  constexpr std::uint64_t kSeed = 20110115;
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> any(-1, 1);
  double worst = 0;
  int steps = 0;
  for (int path = 0; path < 200; ++path) {
    JointVector joints = random_joints(random);
    Pose pose = polycrank_model().flange(joints);
    Twist twist;
    for (int i = 0; i < 6; ++i) twist[i] = any(random);
    twist.head<3>() *= 0.0005 / twist.head<3>().norm();
    twist.tail<3>() *= 0.00125 / twist.tail<3>().norm();
    for (int i = 0; i < 400 && dexterity(joints) > 0.02; ++i, ++steps) {
      pose = moved(pose, twist, 1);
      JointVector next;
      ASSERT_EQ(polycrank_model().inverse(pose, joints, next), ErrorCode::none);
      worst = std::max(worst, (next - joints).norm() / least_norm(joints, twist).norm());
      joints = next;
    }
  }
  std::printf("seed %llu, %d steps of 0.5 mm: at most %.2f times the least norm\n",
              static_cast<unsigned long long>(kSeed), steps, worst);
  EXPECT_GT(steps, 30000);
  EXPECT_LT(worst, 1.5);
}

// straight up; the shoulder pair alone would be stretched after 0.28 m: the elbow pair moves before
TEST(PolycrankRedundancy, NeitherPairStretchesWhileTheOtherCanMove) {
  JointVector joints = polycrank_home();
  Pose pose = polycrank_model().flange(joints);
  double least_bend = 1;
  for (int i = 0; i < 350; ++i) {
    pose.translation().z() += 0.001;
    ASSERT_EQ(polycrank_model().inverse(pose, joints, joints), ErrorCode::none);
    least_bend = std::min({least_bend, std::abs(std::sin(joints[1])), std::abs(std::sin(joints[4]))});
  }
  EXPECT_GT(least_bend, 0.1);
}

// a consequence of the minimum norm; the posture settles where the path closes
TEST(PolycrankRedundancy, ClosedPathDriftsUntilItCloses) {
  JointVector joints = polycrank_home();
  const Pose start = polycrank_model().flange(joints);
  std::vector<double> drift;
  for (int lap = 0; lap < 60; ++lap) {
    const JointVector before = joints;
    for (int i = 1; i <= 200; ++i) {
      const double angle = 2 * M_PI * i / 200;
      Pose pose = start;
      pose.translation() += 0.1 * Eigen::Vector3d(0, std::cos(angle) - 1, std::sin(angle));
      ASSERT_EQ(polycrank_model().inverse(pose, joints, joints), ErrorCode::none);
    }
    drift.push_back((joints - before).norm());
  }
  std::printf("circle of 0.1 m: drift of the joints in lap 1 %.2f rad, lap 10 %.1e rad, lap 60 %.1e rad\n", drift[0],
              drift[9], drift[59]);
  EXPECT_GT(drift.front(), 0.1);
  EXPECT_LT(drift.back(), 1e-6);
  EXPECT_LT(pose_difference(polycrank_model().flange(joints), start), 1e-9);
}

}  // namespace
}  // namespace mrroc::redundancy_test
