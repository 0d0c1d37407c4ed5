// Commands that end in motion without a successor: the robot brakes as the command says, or on its own.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "edp/random_values.hpp"
#include "edp/rig.hpp"
#include "language/stops/common_stop_path.hpp"

namespace mrroc::edp::common_stop_test {
namespace {

/// A macrostep that ends after 0.2 s in motion.
RobotCommand into_motion(const Rig<Gantry>& rig, const JointVector& velocity, const CommonStop& stop) {
  RobotCommand command = joint_command(rig.seen().desired.position + 0.1 * velocity, 100, 100);
  command.joint_velocity = velocity;
  command.joint_acceleration = JointVector::Zero(velocity.size());
  command.stop = stop;
  return command;
}

/// Until the macrostep has ended.
DesiredState moved(Rig<Gantry>& rig, const RobotCommand& command) {
  EXPECT_FALSE(rig.send(command)) << rig.answer.state.error.detail.view();
  while (rig.replies.empty()) rig.tick();
  return rig.seen().desired;
}

JointVector velocity_of(double x, double y, double z, double yaw) {
  return (JointVector(4) << x, y, z, yaw).finished();
}

TEST(CommonStop, IsTheStopOfARobotWithoutASuccessor) {
  EXPECT_TRUE(rc::check([] {
    Rig<Gantry> rig;
    const JointVector velocity = random_vector(4, 0.5);
    const CommonStop stop{static_cast<std::uint16_t>(100 + number(0, 300)), number(-1, 1)};
    const DesiredState from = moved(rig, into_motion(rig, velocity, stop));
    CommonStopPath path;
    path.plan(from, stop, kPeriod);
    for (int k = 1; k <= stop.ticks; ++k) {
      rig.tick();
      RC_ASSERT((rig.seen().desired.position - path.at(k * kPeriod).position).isZero(1e-12));
      RC_ASSERT(rig.seen().braking);
      RC_ASSERT((rig.seen().end.position - path.end().position).isZero(1e-12));
    }
    RC_ASSERT(rig.seen().desired.at_rest());
    RC_ASSERT(rig.seen().counters.stops == 1);
    RC_ASSERT(rig.seen().fault.code == ErrorCode::none);
  }));
}

TEST(CommonStop, IsLeftForTheRobotsOwnWhereItWouldLeaveTheLimits) {
  const JointVector velocity = velocity_of(0.6, 0.3, 0, 0);
  for (const CommonStop stop : {CommonStop{10, 0},    // beyond the acceleration limit
                                CommonStop{4000, 0},  // beyond a position limit
                                CommonStop{0, 5}}) {
    Rig<Gantry> rig;
    const DesiredState from = moved(rig, into_motion(rig, velocity, stop));
    Stop own(rig.model.parameters(), kPeriod);
    own.plan(from);
    for (std::uint32_t k = 1; k <= own.ticks(); ++k) {
      rig.tick();
      EXPECT_TRUE((rig.seen().desired.position - own.at(k * kPeriod).position).isZero(1e-12)) << stop.ticks;
    }
    EXPECT_TRUE(rig.seen().desired.at_rest());
    EXPECT_EQ(rig.seen().fault.code, ErrorCode::none);
  }
}

TEST(CommonStop, EndsWhereTheNextCommandBegins) {
  Rig<Gantry> rig;
  moved(rig, into_motion(rig, velocity_of(0.4, 0, 0, 0.2), {200, 0}));
  rig.run(30);
  const JointVector end = rig.seen().end.position;
  RobotCommand command = joint_command(end, 50, 50);
  ASSERT_FALSE(rig.send(command));
  rig.run(300);
  EXPECT_TRUE((rig.seen().desired.position - end).isZero(1e-12));
  ASSERT_EQ(rig.replies.size(), 2u);
  EXPECT_EQ(rig.replies[1].state.late_commands, 1u);
}

TEST(CommonStop, IsNotThatOfAFault) {
  Rig<Gantry> rig;
  moved(rig, into_motion(rig, velocity_of(0.4, 0, 0, 0), {400, 0}));
  rig.run(20);
  const DesiredState from = rig.seen().desired;
  Stop own(rig.model.parameters(), kPeriod);
  own.plan(from);
  rig.effector.enable(false);
  rig.run(own.ticks() + 2);
  EXPECT_FALSE(rig.hardware.powered);
}

TEST(CommonStop, WrongOnesAreRefused) {
  const double infinity = std::numeric_limits<double>::infinity();
  Rig<Gantry> rig;
  rig.run(5);
  ASSERT_TRUE(rig.send(into_motion(rig, velocity_of(0.1, 0, 0, 0), {10001, 0})));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::invalid_argument);
  for (const double rate : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    ASSERT_TRUE(rig.send(into_motion(rig, velocity_of(0.1, 0, 0, 0), {100, rate})));
    EXPECT_EQ(rig.answer.state.error.code, ErrorCode::not_finite);
  }
}

}  // namespace
}  // namespace mrroc::edp::common_stop_test
