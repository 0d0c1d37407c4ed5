#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "allocations.hpp"
#include "bench/kinematics/robots.hpp"
#include "language/joints/nearest_posture.hpp"

// The guarantees of `nearest_posture`, for every model of every robot in robots/.
namespace mrroc {
namespace {

constexpr double kSame = 1e-9;  // m, rad
constexpr int kCases = 300;

/// Keeps every branch.
class AllBranches final : public BranchReceiver {
 public:
  void add(const JointVector& joints, bool exact) noexcept override {
    (exact ? branches : projected).push_back(joints);
  }
  bool found() noexcept override { return true; }
  std::vector<JointVector> branches, projected;
};

JointVector random_posture(const RobotModel& model, std::mt19937_64& random) {
  JointVector joints(model.joint_count());
  do {
    for (int i = 0; i < joints.size(); ++i) {
      const AxisParameters& axis = model.parameters().axes[static_cast<std::size_t>(i)];
      const double low = std::isfinite(axis.position_min) ? axis.position_min : -std::numbers::pi;
      const double high = std::isfinite(axis.position_max) ? axis.position_max : std::numbers::pi;
      joints[i] = std::uniform_real_distribution<double>(low, high)(random);
    }
  } while (!within_limits(model, joints));
  return joints;
}

double distance(const RobotModel& model, const JointVector& from, const JointVector& to) {
  double sum = 0;
  for (int i = 0; i < from.size(); ++i)
    sum += std::pow((to[i] - from[i]) / model.parameters().axes[static_cast<std::size_t>(i)].velocity_max, 2);
  return sum;
}

/// Minimum distance over all turns of `joints`, from axis `axis` on, that are within the limits.
double least_distance(const RobotModel& model, const JointVector& joints, const JointVector& near, int axis) {
  if (axis == joints.size())
    return within_limits(model, joints) ? distance(model, near, joints) : std::numeric_limits<double>::infinity();
  double least = least_distance(model, joints, near, axis + 1);
  if (const double period = model.joint_period(axis); period > 0)
    for (const int turns : {-2, -1, 1, 2}) {
      JointVector turned = joints;
      turned[axis] += turns * period;
      const AxisParameters& limits = model.parameters().axes[static_cast<std::size_t>(axis)];
      if (turned[axis] < limits.position_min || turned[axis] > limits.position_max) continue;
      least = std::min(least, least_distance(model, turned, near, axis + 1));
    }
  return least;
}

template <class Check>
void for_random_postures(Check&& check) {
  for (const RobotModels& models : bench::load_robots())
    for (const auto& model : models) {
      SCOPED_TRACE(model->parameters().type + " " + std::string(model->name()));
      std::mt19937_64 random(20060101);
      for (int i = 0; i < kCases && !testing::Test::HasFailure(); ++i) {
        const JointVector posture = random_posture(*model, random);
        check(*model, posture, random_posture(*model, random));
      }
    }
}

TEST(PostureLaw, EveryBranchHasThePose) {
  for_random_postures([](const RobotModel& model, const JointVector& posture, const JointVector& near) {
    const Pose pose = model.flange(posture);
    AllBranches all;
    model.branches(pose, near, all);
    for (const JointVector& branch : all.branches) {
      const PoseDeviation off = deviation(model.flange(branch), pose);
      EXPECT_LT(off.position, kSame) << branch.transpose();
      EXPECT_LT(off.rotation, 10 * kSame) << branch.transpose();  // an angle from a product of rotations
    }
  });
}

TEST(PostureLaw, PostureIsNearestToItself) {
  for_random_postures([](const RobotModel& model, const JointVector& posture, const JointVector&) {
    const ToolKinematics kinematics(model);
    const Posture found = nearest_posture(kinematics, kinematics.direct(posture), posture);
    ASSERT_EQ(found.code, ErrorCode::none) << posture.transpose();
    EXPECT_LT((found.joints - posture).cwiseAbs().maxCoeff(), 1e-6) << posture.transpose();
  });
}

TEST(PostureLaw, AcceptsEveryReachablePoseWithinTheLimits) {
  for_random_postures([](const RobotModel& model, const JointVector& posture, const JointVector& near) {
    const ToolKinematics kinematics(model);
    const Pose pose = kinematics.direct(posture);
    const Posture found = nearest_posture(kinematics, pose, near);
    ASSERT_EQ(found.code, ErrorCode::none) << posture.transpose() << " from " << near.transpose();
    EXPECT_TRUE(within_limits(model, found.joints));
    const PoseDeviation off = deviation(kinematics.direct(found.joints), pose);
    EXPECT_LT(off.position, kSame);
    EXPECT_LT(off.rotation, 10 * kSame);
  });
}

TEST(PostureLaw, NoTurnOfAnyBranchIsNearer) {
  for_random_postures([](const RobotModel& model, const JointVector& posture, const JointVector& near) {
    const ToolKinematics kinematics(model);
    const Pose pose = kinematics.direct(posture);
    const Posture found = nearest_posture(kinematics, pose, near);
    AllBranches all;
    kinematics.branches(pose, near, all);
    for (const JointVector& branch : all.branches) {
      const double least = least_distance(model, branch, near, 0);
      EXPECT_LE(distance(model, near, found.joints), least * (1 + 1e-12)) << branch.transpose();
    }
  });
}

TEST(PostureLaw, AcceptsAPoseThatIsAMicrometreOff) {
  for_random_postures([](const RobotModel& model, const JointVector& posture, const JointVector& near) {
    const ToolKinematics kinematics(model);
    Pose pose = kinematics.direct(posture);
    pose.translation() += Eigen::Vector3d(6e-7, -6e-7, 5e-7);
    const Posture found = nearest_posture(kinematics, pose, near);
    ASSERT_EQ(found.code, ErrorCode::none) << posture.transpose() << " from " << near.transpose();
    EXPECT_LE(deviation(kinematics.direct(found.joints), pose).position, kPositionTolerance);
  });
}

TEST(PostureLaw, RefusesAPoseFarAway) {
  for_random_postures([](const RobotModel& model, const JointVector& posture, const JointVector& near) {
    const ToolKinematics kinematics(model);
    Pose pose = kinematics.direct(posture);
    pose.translation() += Eigen::Vector3d(100, 100, 100);
    EXPECT_NE(nearest_posture(kinematics, pose, near).code, ErrorCode::none);
  });
}

TEST(PostureLaw, DoesNotAllocate) {
  for_random_postures([](const RobotModel& model, const JointVector& posture, const JointVector& near) {
    const ToolKinematics kinematics(model);
    const Pose pose = kinematics.direct(posture);
    const std::uint64_t before = test::allocations();
    const Posture found = nearest_posture(kinematics, pose, near);
    EXPECT_EQ(test::allocations(), before) << found.joints.transpose();
  });
}

}  // namespace
}  // namespace mrroc
