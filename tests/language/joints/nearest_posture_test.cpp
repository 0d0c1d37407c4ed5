#include "language/joints/nearest_posture.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "language/fake_model.hpp"

namespace mrroc::nearest_posture_test {
namespace {

/// A gantry with branches that a test sets, for any pose. Its motor 0 covers half of its joint's range.
class BranchingModel final : public fakes::FakeModel {
 public:
  BranchingModel() : FakeModel(4) { parameters_.axes[0].motor_max = 100; }
  void branches(const Pose&, const JointVector&, BranchReceiver& receiver) const noexcept override {
    for (const auto& [joints, exact] : given) receiver.add(joints, exact);
  }
  std::vector<std::pair<JointVector, bool>> given;
};

JointVector joints_at(double x, double y = 0, double turn = 0) {
  JointVector joints(4);
  joints << x, y, 0, turn;
  return joints;
}

Posture nearest(const BranchingModel& model, const JointVector& near = joints_at(0)) {
  return nearest_posture(ToolKinematics(model), Pose::Identity(), near);
}

TEST(NearestPosture, IsTheNearestWithinTheMotorLimitsOfAnyNumberOfBranches) {
  constexpr unsigned kSeed = 20060101;
  RecordProperty("seed", kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> joint(-2, 2);
  for (std::size_t count = 1; count <= 60; ++count) {
    BranchingModel model;
    const JointVector near = joints_at(joint(random), joint(random), joint(random));
    const JointVector* least = nullptr;
    model.given.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      model.given.emplace_back(joints_at(joint(random), joint(random), joint(random)), true);
      const JointVector& branch = model.given.back().first;
      if (branch[0] <= 1 && (least == nullptr || (branch - near).norm() < (*least - near).norm())) least = &branch;
    }
    const Posture found = nearest(model, near);
    ASSERT_EQ(found.code, least != nullptr ? ErrorCode::none : ErrorCode::motor_limit) << "seed " << kSeed;
    if (least != nullptr) {
      ASSERT_EQ(found.joints, *least) << count << " branches, seed " << kSeed;
    }
  }
}

TEST(NearestPosture, IsTheFirstOfEquallyNearBranches) {
  BranchingModel model;
  model.given = {{joints_at(0, 1), true}, {joints_at(0, -1), true}};
  EXPECT_EQ(nearest(model).joints, joints_at(0, 1));
  std::swap(model.given[0], model.given[1]);
  EXPECT_EQ(nearest(model).joints, joints_at(0, -1));
}

TEST(NearestPosture, PrefersAPostureWithinTheTolerancesToASmallerSum) {
  BranchingModel model;
  const JointVector beyond = joints_at(1.05e-3), within = joints_at(0.9e-3, 0, 4.5e-3);
  model.given = {{beyond, false}, {within, false}};
  for (int order = 0; order < 2; ++order) {
    const Posture found = nearest(model);
    EXPECT_EQ(found.code, ErrorCode::none);
    EXPECT_EQ(found.joints, within);
    EXPECT_NEAR(found.deviation.position, 0.9e-3, 1e-12);
    EXPECT_NEAR(found.deviation.rotation, 4.5e-3, 1e-12);
    std::swap(model.given[0], model.given[1]);
  }
}

TEST(NearestPosture, PrefersAnExactBranchToNearerProjectedOnes) {
  BranchingModel model;
  model.given = {{joints_at(0.5e-3), false}, {joints_at(0.5, 0.5), true}, {joints_at(0.4e-3), false}};
  EXPECT_EQ(nearest(model).joints, joints_at(0.5, 0.5));
}

TEST(NearestPosture, NamesAxisAndValueOfAPostureBeyondALimit) {
  BranchingModel model;
  model.given = {{joints_at(0, 3), true}, {joints_at(1.5), true}};
  Posture found = nearest(model);
  EXPECT_EQ(found.code, ErrorCode::motor_limit);
  EXPECT_EQ(found.axis, 0);
  EXPECT_DOUBLE_EQ(found.value, 150);
  model.given = {{joints_at(1.5, 1.5), true}, {joints_at(0, 2.1), true}};
  found = nearest(model);
  EXPECT_EQ(found.code, ErrorCode::joint_limit);
  EXPECT_EQ(found.axis, 1);
  EXPECT_DOUBLE_EQ(found.value, 2.1);
}

TEST(NearestPosture, MissingPostureIsOutOfTheWorkspace) {
  BranchingModel model;
  EXPECT_EQ(nearest(model).code, ErrorCode::out_of_workspace);
  model.given = {{joints_at(0.1), false}};
  const Posture found = nearest(model);
  EXPECT_EQ(found.code, ErrorCode::out_of_workspace);
  EXPECT_NEAR(found.deviation.position, 0.1, 1e-12);
}

}  // namespace
}  // namespace mrroc::nearest_posture_test
