// What follows a motion that its robots have given up or ended: later commands, other motions, reports.
#include <gtest/gtest.h>

#include "edp/servo/group_rig.hpp"

namespace mrroc::edp::group_end_test {
namespace {

TEST(GroupEnd, ImpactInTheLastTickOfAMotionIsReported) {
  Pair pair;
  pair.move(kVelocity);
  pair.run(99);
  force_limit(pair);
  pair.run(1);
  pair.a.sensor.extra.setZero();
  pair.run(400);
  EXPECT_TRUE(pair.a.seen().desired.at_rest() && pair.b.seen().desired.at_rest());
  EXPECT_EQ(pair.a.seen().interruption.code, ErrorCode::force_limit);
  EXPECT_EQ(pair.a.seen().interruptions, 1u);
}

TEST(GroupEnd, RobotWithoutASuccessorStopsTheOthers) {
  Pair pair;
  pair.move(kVelocity);
  pair.run(10);
  ASSERT_FALSE(pair.b.send(Pair::command(pair.b, kVelocity, kStop)));
  pair.run(93);
  EXPECT_EQ(pair.a.seen().counters.stops, 1u);
  EXPECT_EQ(pair.b.seen().given_up, kStop.group);
  pair.run(kStop.ticks);
  EXPECT_TRUE(pair.a.seen().desired.at_rest() && pair.b.seen().desired.at_rest());
  EXPECT_LT((pair.a.seen().desired.position - pair.b.seen().desired.position).norm(), 2 * kPeriod * kVelocity.norm());
  EXPECT_EQ(pair.b.seen().counters.stops, 0u);
}

TEST(GroupEnd, CommandsOfAMotionThatIsGivenUpHold) {
  for (const Break fault : {drive_fault, force_limit}) {
    Pair pair;
    pair.move(kVelocity);
    pair.run(10);
    RobotCommand next = Pair::command(pair.b, kVelocity, kStop);
    ASSERT_FALSE(pair.b.send(next));  // planned already
    pair.run(40);
    fault(pair);
    pair.run(400);
    const JointVector rest = pair.b.seen().desired.position;
    EXPECT_TRUE(pair.b.seen().desired.at_rest());
    next.joints = rest + 0.1 * kVelocity;
    EXPECT_TRUE(well(pair.b.exchange(next)));
    pair.run(200);
    EXPECT_EQ(pair.b.seen().desired.position, rest);
    next.stop.group = kStop.group + 1;
    EXPECT_TRUE(well(pair.b.exchange(next)));
    pair.run(20);
    EXPECT_NE(pair.b.seen().desired.position, rest);
    EXPECT_EQ(pair.b.seen().fault.code, ErrorCode::none);
  }
}

/// At the end of a motion, which the next one of a single robot continues; not long before.
TEST(GroupEnd, RobotThatContinuesInAnotherMotionIsLeftAlone) {
  for (const int before : {60, 92}) {
    Pair pair;
    pair.move(kVelocity);
    pair.run(10);
    ASSERT_FALSE(pair.b.send(Pair::command(pair.b, kVelocity, {kStop.ticks, 0, kStop.group + 1})));
    pair.run(before - 10);
    drive_fault(pair);
    pair.run(50);
    EXPECT_EQ(pair.b.seen().desired.velocity.isApprox(kVelocity, 1e-9), before == 92);
    EXPECT_EQ(pair.b.effector.counters().late, before == 92 ? 0u : 1u);
  }
}

/// As every late command: one of several robots in motion holds, another one is executed.
TEST(GroupEnd, CommandThatWouldHaveContinuedTheMotionIsLate) {
  for (const std::uint16_t ticks : {std::uint16_t{0}, kStop.ticks}) {
    Pair pair;
    pair.move(kVelocity);
    pair.run(20);
    RobotCommand next = joint_command(pair.b.seen().end.position + 0.1 * kVelocity, 100, 100);  // and rest there
    next.stop = {ticks, 0, kStop.group + 1};
    pair.run(60);
    drive_fault(pair);
    pair.run(4);  // the other robot brakes already
    ASSERT_FALSE(pair.b.send(next)) << pair.b.answer.state.error.detail.view();
    EXPECT_EQ(pair.b.effector.counters().late, 1u);
    pair.run(2000);
    EXPECT_TRUE(pair.b.seen().desired.at_rest());
    EXPECT_EQ((pair.b.seen().desired.position - next.joints).isZero(1e-9), ticks == 0);
    EXPECT_EQ(pair.b.seen().fault.code, ErrorCode::none);
  }
}

/// The motion ends in the tick of the impact, and another one has been commanded.
TEST(GroupEnd, ImpactAtTheBoundaryOfTwoMotionsStopsTheSecondOne) {
  for (const std::uint64_t group : {std::uint64_t{0}, kStop.group + 1}) {
    for (const int before : {99, 100, 101}) {
      Pair pair;
      pair.move(kVelocity);
      pair.run(10);
      ASSERT_FALSE(pair.a.send(Pair::command(pair.a, kVelocity, {kStop.ticks, 0, group})));
      pair.run(before - 10);
      force_limit(pair);
      pair.run(1);
      pair.a.sensor.extra.setZero();
      pair.run(150);
      EXPECT_EQ(pair.a.seen().interruptions, 1u) << group << " " << before;
      pair.run(100);
      EXPECT_TRUE(pair.a.seen().desired.at_rest()) << group << " " << before;
    }
  }
}

TEST(GroupEnd, ImpactBeforeAFaultIsNotReportedAfterTheRecovery) {
  for (const Break fault : {drive_fault, emergency_stop, switched_off}) {
    Pair pair;
    pair.move(kVelocity);
    pair.run(50);
    force_limit(pair);
    pair.run(1);
    fault(pair);
    pair.a.sensor.extra.setZero();
    pair.run(400);
    pair.a.hardware.fault = ErrorCode::none;
    pair.a.operators.reset();
    RobotCommand recover;
    recover.kind = CommandKind::recover;
    EXPECT_TRUE(well(pair.a.exchange(recover)));
    pair.run(10);
    ASSERT_TRUE(pair.a.seen().enabled());
    EXPECT_TRUE(well(pair.a.exchange(joint_command(pair.a.seen().desired.position, 20, 10))));
  }
}

}  // namespace
}  // namespace mrroc::edp::group_end_test
