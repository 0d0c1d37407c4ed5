#include "kinematics/loaded_model.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <memory>
#include <random>

#include "kinematics/chain_model.hpp"
#include "kinematics/chains.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::kinematics {
namespace {

/// An arm of chain `chain` whose every axis moves 2 kg m2.
std::shared_ptr<const RobotModel> even_arm(const SerialChain& chain,
                                           double torque = std::numeric_limits<double>::infinity()) {
  RobotParameters parameters;
  parameters.axes.resize(static_cast<std::size_t>(chain.size()));
  for (AxisParameters& axis : parameters.axes) {
    axis.position_min = -3;
    axis.position_max = 3;
    axis.velocity_max = 1;
    axis.acceleration_max = 5;
    axis.jerk_max = 50;
    axis.inertia_min = 1;
    axis.inertia_max = 2;
    axis.torque_max = torque;
  }
  parameters.home = JointVector::Zero(chain.size());
  return std::make_shared<ChainModel>("nominal", parameters, chain, JointVector::Ones(chain.size()));
}

/// A load 1.5 m from a turning axis, in a plane across it, and one on a slide.
TEST(LoadedModel, LimitsShrinkByTheInertiaOfTheLoad) {
  const Pose out(Eigen::Translation3d(1, 0, 0));
  for (const bool slides : {false, true}) {
    const RobotModels bare{even_arm(SerialChain({{Pose::Identity(), Eigen::Vector3d::UnitZ(), slides}}, out))};
    const RobotModels loaded = with_load(bare, {3, {0.5, 0, 7}});
    const double part = 2 / (2 + 3 * (slides ? 1 : 1.5 * 1.5));
    const AxisParameters& axis = loaded.front()->parameters().axes.front();
    EXPECT_NEAR(axis.acceleration_max, part * 5, 1e-12);
    EXPECT_NEAR(axis.jerk_max, part * 50, 1e-12);
    EXPECT_EQ(axis.velocity_max, 1);
    EXPECT_EQ(axis.position_max, 3);
  }
}

/// The weight of 3 kg at 1.5 m needs 44 N m.
TEST(LoadedModel, LimitsAreWhatTheTorqueLeaves) {
  const Pose out(Eigen::Translation3d(1, 0, 0));
  const SerialChain chain({{Pose::Identity(), Eigen::Vector3d::UnitZ(), false}}, out);
  const double weight = 3 * 9.81 * 1.5, inertia = 2 + 3 * 1.5 * 1.5;
  for (const auto& [torque, expected] : {std::pair{weight + 20, 20 / inertia}, {weight + 1000, 5.0}}) {
    const auto loaded = with_load({even_arm(chain, torque)}, {3, {0.5, 0, 0}});
    const AxisParameters& axis = loaded.front()->parameters().axes.front();
    EXPECT_NEAR(axis.acceleration_max, expected, 1e-12);
    EXPECT_NEAR(axis.jerk_max, 10 * expected, 1e-11);
  }
  EXPECT_THROW(with_load({even_arm(chain, weight - 0.1)}, {3, {0.5, 0, 0}}), SystemError);
}

TEST(LoadedModel, WithoutAMassNothingChanges) {
  const RobotModels bare{even_arm(test::ur5e())};
  EXPECT_EQ(with_load(bare, {}), bare);
}

TEST(LoadedModel, IsTheSameRobotOtherwise) {
  std::mt19937_64 random(1);
  std::printf("seed 1\n");
  const RobotModels bare{even_arm(test::ur5e())};
  const auto loaded = with_load(bare, {5, {0.05, 0, 0.1}}).front();
  const RobotModel& own = *bare.front();
  EXPECT_EQ(loaded->name(), own.name());
  for (int round = 0; round < 100; ++round) {
    const JointVector q = test::random_joints(random, 6);
    const Pose pose = own.flange(q);
    EXPECT_EQ(loaded->flange(q).matrix(), pose.matrix());
    JointVector one = q, other = q;
    EXPECT_EQ(loaded->inverse(pose, q, one), own.inverse(pose, q, other));
    EXPECT_EQ(one, other);
    EXPECT_EQ(loaded->jacobian(q, Eigen::Vector3d::Zero()), own.jacobian(q, Eigen::Vector3d::Zero()));
    EXPECT_EQ(loaded->transmission(q), own.transmission(q));
  }
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(loaded->joint_period(i), own.joint_period(i));
    const auto& axes = loaded->parameters().axes;
    EXPECT_LT(axes[static_cast<std::size_t>(i)].acceleration_max, 5);
  }
}

}  // namespace
}  // namespace mrroc::kinematics
