#include "kinematics/chain_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "allocations.hpp"
#include "kinematics/chains.hpp"

namespace mrroc::kinematics {
namespace {

using namespace test;

RobotParameters parameters_of(const SerialChain& chain, double limit) {
  RobotParameters parameters;
  parameters.type = "arm";
  parameters.axes.resize(static_cast<std::size_t>(chain.size()));
  for (AxisParameters& axis : parameters.axes) {
    axis.position_min = -limit;
    axis.position_max = limit;
  }
  parameters.home = JointVector::Zero(chain.size());
  return parameters;
}

ChainModel model_of(const SerialChain& chain, double limit = 2.8) {
  return {"nominal", parameters_of(chain, limit), chain, JointVector::Ones(chain.size())};
}

/// Counts postures, and looks for one within +-limit.
class Receiver final : public BranchReceiver {
 public:
  Receiver(const ChainModel& model, const Pose& pose, double limit) : model_(model), pose_(pose), limit_(limit) {}
  void add(const JointVector& joints, bool exact) noexcept override {
    ++count;
    EXPECT_TRUE(exact);
    EXPECT_LT(displacement(model_.flange(joints), pose_).norm(), 1e-8);
    double beyond = 0;
    for (const double joint : joints) beyond = std::max(beyond, std::abs(std::remainder(joint, 2 * std::numbers::pi)));
    found_ = found_ || beyond <= limit_ + 1e-12;
  }
  bool found() noexcept override { return found_; }
  int count = 0;

 private:
  const ChainModel& model_;
  const Pose& pose_;
  double limit_;
  bool found_ = false;
};

TEST(ChainModel, InverseOfAPostureIsThePosture) {
  std::mt19937_64 random(1);
  std::printf("seed 1\n");
  for (const SerialChain& chain : {ur5e(), puma560(), irb140(), panda(), random_chain(random, 6, true)}) {
    const ChainModel model = model_of(chain);
    for (int round = 0; round < 1000; ++round) {
      const JointVector q = 2 * random_joints(random, chain.size());  // beyond one revolution, too
      JointVector found;
      const ErrorCode code = model.inverse(model.flange(q), q, found);
      ASSERT_TRUE(code == ErrorCode::none || code == ErrorCode::singular);
      ASSERT_LT((found - q).norm(), 1e-6) << round;
    }
  }
}

/// Poses that some posture within the limits reaches: one is found for nearly all, whatever the start.
TEST(ChainModel, PosturesWithinTheLimitsAreFound) {
  constexpr int kPoses = 2000;
  constexpr double kLimit = 2.0;
  std::mt19937_64 random(2);
  std::printf("seed 2\n");
  for (const SerialChain& chain : {ur5e(), puma560(), panda()}) {
    const ChainModel model = model_of(chain, kLimit);
    int reached = 0;
    for (int i = 0; i < kPoses; ++i) {
      const JointVector q = kLimit / std::numbers::pi * random_joints(random, chain.size());
      const Pose pose = model.flange(q);
      Receiver receiver(model, pose, kLimit);
      model.branches(pose, kLimit / std::numbers::pi * random_joints(random, chain.size()), receiver);
      reached += receiver.found() ? 1 : 0;
    }
    std::printf("%d of %d\n", reached, kPoses);
    EXPECT_GE(reached, kPoses * 998 / 1000);
  }
}

/// Looks for one posture.
class Among final : public BranchReceiver {
 public:
  explicit Among(const JointVector& wanted) : wanted_(wanted) {}
  void add(const JointVector& joints, bool) noexcept override {
    double difference = 0;
    for (int i = 0; i < joints.size(); ++i)
      difference = std::max(difference, std::abs(std::remainder(joints[i] - wanted_[i], 2 * std::numbers::pi)));
    found_ = found_ || difference < 1e-5;
  }
  bool found() noexcept override { return found_; }

 private:
  const JointVector& wanted_;
  bool found_ = false;
};

/// Every posture within the limits is among the branches of its pose, with and without a closed form; the last arm has
/// wrist axes 0.1 m apart.
TEST(ChainModel, ThePostureIsAmongTheBranches) {
  constexpr int kPostures = 2000;
  constexpr double kLimit = 2.6;
  std::mt19937_64 random(6);
  std::printf("seed 6\n");
  const SerialChain apart = chain_of({{0.267, 0, -kRight},
                                      {0, 0.29, 0, -1.38},
                                      {0, 0.0775, -kRight, 1.38},
                                      {0.3425, 0, kRight},
                                      {0, 0.1, -kRight},
                                      {0.097, 0, 0}});
  EXPECT_FALSE(ClosedForm(apart));
  for (const SerialChain& chain : {ur5e(), puma560(), irb140(), apart}) {
    const ChainModel model = model_of(chain, kLimit);
    int among = 0;
    for (int i = 0; i < kPostures; ++i) {
      const JointVector q = kLimit / std::numbers::pi * random_joints(random, 6);
      Among receiver(q);
      model.branches(model.flange(q), JointVector::Zero(6), receiver);
      among += receiver.found() ? 1 : 0;
    }
    std::printf("%d of %d\n", among, kPostures);
    EXPECT_GE(among, kPostures * 998 / 1000);
  }
}

TEST(ChainModel, PosesBeyondTheReachAreRefused) {
  std::mt19937_64 random(3);
  std::printf("seed 3\n");
  for (const SerialChain& chain : {ur5e(), puma560(), panda()}) {
    const ChainModel model = model_of(chain);
    const JointVector near = JointVector::Zero(chain.size());
    JointVector joints = near;
    for (int i = 0; i < 100; ++i) {
      Pose pose = random_pose(random);
      pose.translation() = 10 * random_vector(random).normalized();
      EXPECT_EQ(model.inverse(pose, near, joints), ErrorCode::out_of_workspace);
      EXPECT_EQ(joints, near);
    }
    Pose sheared = model.flange(near);
    sheared.linear()(0, 1) += 0.1;
    EXPECT_EQ(model.inverse(sheared, near, joints), ErrorCode::out_of_workspace);
    Pose nowhere = model.flange(near);
    nowhere.translation()[0] = std::nan("");
    EXPECT_EQ(model.inverse(nowhere, near, joints), ErrorCode::out_of_workspace);
  }
}

/// The servo thread and the steps of a Move call these.
TEST(ChainModel, NothingIsAllocated) {
  std::mt19937_64 random(4);
  std::printf("seed 4\n");
  for (const SerialChain& chain : {ur5e(), puma560(), panda(), random_chain(random, 8, true)}) {
    const ChainModel model = model_of(chain);
    for (int round = 0; round < 100; ++round) {
      const JointVector q = random_joints(random, chain.size());
      const Pose pose = model.flange(q), beyond = Eigen::Translation3d(9, 0, 0) * pose;
      Receiver receiver(model, pose, 2.8);
      JointVector joints = q;
      {
        const mrroc::test::Counting counting;
        model.inverse(pose, q, joints);
        model.inverse(beyond, q, joints);
        model.branches(pose, q, receiver);
        joints += model.jacobian(q, Eigen::Vector3d::UnitX()).row(0).transpose();
        joints += model.transmission(q) * q;
      }
      ASSERT_EQ(mrroc::test::Counting::counted(), 0U) << chain.size() << " axes, round " << round;
    }
  }
}

TEST(ChainModel, MotorsTurnByTheGears) {
  const SerialChain chain = ur5e();
  const JointVector gear = (JointVector(6) << 100, -100, 101, 50, 50, 1).finished();
  const ChainModel model("geared", parameters_of(chain, 2), chain, gear);
  const JointVector q = JointVector::LinSpaced(6, -1, 1);
  JointVector motors, joints;
  ASSERT_EQ(model.joints_to_motors(q, motors), ErrorCode::none);
  ASSERT_EQ(model.motors_to_joints(motors, joints), ErrorCode::none);
  EXPECT_LT((joints - q).norm(), 1e-15);
  EXPECT_LT((motors - model.transmission(q) * q).norm(), 1e-12);
  EXPECT_THROW(ChainModel("nominal", parameters_of(chain, 2), chain, JointVector::Zero(6)), std::invalid_argument);
  EXPECT_THROW(ChainModel("nominal", parameters_of(chain, 2), chain, JointVector::Ones(5)), std::invalid_argument);
}

}  // namespace
}  // namespace mrroc::kinematics
