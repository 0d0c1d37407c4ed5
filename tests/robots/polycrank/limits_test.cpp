#include <gtest/gtest.h>

#include <limits>

#include "robots/polycrank/polycrank_fixture.hpp"

namespace mrroc::limits_test {
namespace {

TEST(PolycrankLimits, JointsAndMotorsAreUnlimited) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(per_axis(&AxisParameters::position_min), JointVector::Constant(7, -kInfinity));
  EXPECT_EQ(per_axis(&AxisParameters::position_max), JointVector::Constant(7, kInfinity));
  EXPECT_EQ(per_axis(&AxisParameters::motor_min), JointVector::Constant(7, -kInfinity));
  EXPECT_EQ(per_axis(&AxisParameters::motor_max), JointVector::Constant(7, kInfinity));
}

TEST(PolycrankLimits, MotorsTurnWithTheirOwnJointOnly) {
  const JointMatrix g = polycrank_model().transmission(polycrank_home());
  EXPECT_EQ(g, JointMatrix(JointVector(g.diagonal()).asDiagonal()));
  JointVector motors;
  ASSERT_EQ(polycrank_model().joints_to_motors(polycrank_home(), motors), ErrorCode::none);
  EXPECT_LT((motors - g * polycrank_home() - per_axis(&AxisParameters::motor_synchro)).norm(), 1e-9);
}

TEST(PolycrankLimits, HomePointsTheToolDownInFrontOfTheArm) {
  Pose expected = Pose::Identity();
  expected.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  expected.translation() << 0.907, 0, -0.223;
  EXPECT_LT(pose_difference(ToolKinematics(polycrank_model()).direct(polycrank_home()), expected), 1e-8);
}

TEST(PolycrankLimits, FrictionAtFullSpeedLeavesTheDrivesCurrent) {
  const JointVector speed = polycrank_model().transmission(polycrank_home()) * per_axis(&AxisParameters::velocity_max);
  const JointVector share = speed.cwiseProduct(per_axis(&AxisParameters::viscous_friction))
                                .cwiseQuotient(per_axis(&AxisParameters::torque_constant))
                                .cwiseQuotient(per_axis(&AxisParameters::current_max));
  EXPECT_LT(share.maxCoeff(), 0.6) << share.transpose();
  EXPECT_LT(speed.maxCoeff(), 250) << "the IRp-6's panic speed of these drives";
}

}  // namespace
}  // namespace mrroc::limits_test
