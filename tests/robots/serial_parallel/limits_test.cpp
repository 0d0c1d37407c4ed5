#include <gtest/gtest.h>

#include "cases.hpp"
#include "mrroc/robots/serial_parallel.hpp"

namespace mrroc::limits_test {
namespace {

TEST(SerialParallelTransmission, MotorsReturnToTheirJoints) {
  EXPECT_TRUE(rc::check([] {
    const JointVector joints = any_posture();
    JointVector motors, back;
    RC_ASSERT(machine().joints_to_motors(joints, motors) == ErrorCode::none);
    RC_ASSERT(machine().motors_to_joints(motors, back) == ErrorCode::none);
    RC_ASSERT((back - joints).cwiseAbs().maxCoeff() < 1e-12);
  }));
}

TEST(SerialParallelTransmission, HasNineTurnsOfTheMotorAndAScrewOfFiveMillimetres) {
  JointVector joints = machine().parameters().home, motors, extended;
  ASSERT_EQ(machine().joints_to_motors(joints, motors), ErrorCode::none);
  joints.array() += 0.005;
  ASSERT_EQ(machine().joints_to_motors(joints, extended), ErrorCode::none);
  JointVector expected(6);
  expected << -18 * M_PI, -18 * M_PI, -18 * M_PI, 0.5, 0.5, 0.5;
  EXPECT_LT((extended - motors - expected).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((machine().transmission(joints) * JointVector::Constant(6, 0.005) - expected).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SerialParallelTransmission, JointsBeyondTheTripodHaveNoMotors) {
  const JointVector home = machine().parameters().home;
  JointVector leaning = home, untouched = JointVector::Constant(6, 7);
  leaning[0] = 0.245;
  leaning[2] = 0.375;
  EXPECT_EQ(machine().joints_to_motors(leaning, untouched), ErrorCode::joint_limit);
  EXPECT_EQ(untouched, JointVector::Constant(6, 7));
}

// a robot at a limit may overshoot it slightly; poses cannot be planned there
TEST(SerialParallelTransmission, JointsKeepTheirMotorsForOneDegreeBeyondAPassiveLimit) {
  JointVector joints = machine().parameters().home, reached = joints, motors;
  Pose pose = machine().flange(joints);
  while (machine().inverse(pose, joints, reached) == ErrorCode::none) pose.translation().y() += 1e-5;
  const auto centre_of = [](const Pose& flange) -> Eigen::Vector3d {
    return Eigen::Vector3d(1, -1, -1).asDiagonal() * (flange * Eigen::Vector3d(0, 0, -geometry().wrist_to_flange));
  };
  const auto code_beyond = [&](double way) {
    Pose beyond = pose;
    beyond.translation().y() += way;
    reached.head<3>() = tripod().legs(tripod().placement_of(centre_of(beyond)));
    return machine().joints_to_motors(reached, motors);
  };
  EXPECT_EQ(code_beyond(0.002), ErrorCode::none);
  EXPECT_EQ(code_beyond(0.02), ErrorCode::joint_limit);
}

TEST(SerialParallelTransmission, InvalidInputGivesACodeOrFiniteNumbers) {
  EXPECT_TRUE(rc::check([] {
    const JointVector garbage = any_garbage_joints(6);
    JointVector result = JointVector::Zero(6);
    const bool to_motors = machine().joints_to_motors(garbage, result) == ErrorCode::none;
    RC_ASSERT(result.allFinite());
    const bool to_joints = machine().motors_to_joints(garbage, result) == ErrorCode::none;
    RC_ASSERT(result.allFinite());
    RC_ASSERT(garbage.allFinite() || !(to_motors || to_joints));
  }));
}

TEST(SerialParallelLimits, JointLimitsAreWithinTheMotorLimits) {
  for (int axis = 0; axis < 6; ++axis) {
    const AxisParameters& parameters = machine().parameters().axes[static_cast<std::size_t>(axis)];
    for (const double limit : {parameters.position_min, parameters.position_max}) {
      const double motor = geometry().gears[axis] * (limit - geometry().synchro[axis]) + parameters.motor_synchro;
      EXPECT_GE(motor, parameters.motor_min) << parameters.name;
      EXPECT_LE(motor, parameters.motor_max) << parameters.name;
    }
  }
}

TEST(SerialParallelLimits, HomeIsWithinThemWithAMarginOnEveryJoint) {
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  const JointVector home = machine().parameters().home;
  const JointVector room = (home - low).cwiseMin(high - home).cwiseQuotient(high - low);
  EXPECT_GT(room.minCoeff(), 0.2) << room.transpose();
}

// the board of an engraving task: 200 mm by 200 mm, 40 mm up and down, the spindle straight down
TEST(SerialParallelLimits, SpindleReachesABoardOfTwentyCentimetres) {
  const JointVector low = per_axis(&AxisParameters::position_min), high = per_axis(&AxisParameters::position_max);
  const JointVector home = machine().parameters().home;
  const Pose tool_inverse = machine().default_tool().inverse();
  JointVector lowest = high, highest = low;
  for (double x = -0.05; x < 0.151; x += 0.01) {
    for (double y = -0.1; y < 0.101; y += 0.01) {
      for (double z = -0.565; z < -0.5249; z += 0.005) {
        JointVector joints;
        ASSERT_EQ(machine().inverse(SerialParallel::tool_down(x, y, z) * tool_inverse, home, joints), ErrorCode::none)
            << x << " " << y << " " << z;
        lowest = lowest.cwiseMin(joints);
        highest = highest.cwiseMax(joints);
      }
    }
  }
  std::printf(
      "over the board: legs %.3f .. %.3f, %.3f .. %.3f, %.3f .. %.3f m, wrist %.2f .. %.2f, %.2f .. %.2f, %.2f "
      ".. %.2f rad\n",
      lowest[0], highest[0], lowest[1], highest[1], lowest[2], highest[2], lowest[3], highest[3], lowest[4], highest[4],
      lowest[5], highest[5]);
  EXPECT_TRUE((lowest.array() > low.array()).all()) << lowest.transpose();
  EXPECT_TRUE((highest.array() < high.array()).all()) << highest.transpose();
  EXPECT_LT(highest[4], -0.2) << "away from the straight wrist, which is singular";
}

TEST(SerialParallelLimits, DrivesCarryTheirFrictionAndTheirRotorsAtFullSpeedAndAcceleration) {
  for (int axis = 0; axis < 6; ++axis) {
    const AxisParameters& p = machine().parameters().axes[static_cast<std::size_t>(axis)];
    const double gear = std::abs(geometry().gears[axis]);
    const double torque = gear * (p.viscous_friction * p.velocity_max + p.rotor_inertia * p.acceleration_max);
    const double available = std::min(p.current_max, p.regulator_output_max * p.regulator_current_gain);
    EXPECT_LT(torque / p.torque_constant, 0.8 * available) << p.name;
  }
}

}  // namespace
}  // namespace mrroc::limits_test
