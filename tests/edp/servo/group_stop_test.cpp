// Robots that share a motion: where one of them stops alone, the others stop, too.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "edp/random_values.hpp"
#include "edp/servo/group_rig.hpp"
#include "language/stops/common_stop_path.hpp"

namespace mrroc::edp::group_stop_test {
namespace {

TEST(GroupStop, OthersBrakeInStepFromTheNextTickOn) {
  for (const Break fault : {drive_fault, drives_lost, emergency_stop, switched_off, force_limit, blind_sensor}) {
    EXPECT_TRUE(rc::check([fault] {
      const JointVector velocity = random_vector(4, 0.3);
      const int before = *rc::gen::inRange(2, 99);
      Pair first(false), second(true);
      for (Pair* pair : {&first, &second}) {
        pair->move(velocity);
        pair->run(before);
        fault(*pair);
        pair->run(1);
        RC_ASSERT(pair->b.seen().given_up == 0u);
        CommonStopPath path;
        path.plan(pair->b.seen().desired, kStop, kPeriod);
        for (int k = 1; k <= kStop.ticks; ++k) {
          pair->run(1);
          RC_ASSERT((pair->b.seen().desired.position - path.at(k * kPeriod).position).isZero(1e-12));
        }
        RC_ASSERT(pair->b.seen().desired.at_rest());
        RC_ASSERT(pair->b.seen().enabled());
        RC_ASSERT(pair->b.seen().counters.stops == 0u);
      }
      // whichever servo runs first
      RC_ASSERT(first.a.seen().desired.position == second.a.seen().desired.position);
      RC_ASSERT(first.b.seen().desired.position == second.b.seen().desired.position);
    }));
  }
}

TEST(GroupStop, RobotAtItsForceLimitBrakesWithTheOthers) {
  EXPECT_TRUE(rc::check([] {
    Pair pair(*rc::gen::arbitrary<bool>());
    pair.move(random_vector(4, 0.3));
    pair.run(*rc::gen::inRange(2, 99));
    force_limit(pair);
    pair.run(1);
    pair.a.sensor.extra.setZero();  // a short impact is not forgotten
    for (int k = 0; k < kStop.ticks; ++k) {
      pair.run(1);
      RC_ASSERT(pair.a.seen().desired.position == pair.b.seen().desired.position);
    }
    RC_ASSERT(pair.a.seen().desired.at_rest());
    RC_ASSERT(pair.a.replies.size() == 1u);
    RC_ASSERT(pair.a.replies[0].state.error.code == ErrorCode::force_limit);
    RC_ASSERT(pair.b.replies.size() == 1u);
    RC_ASSERT(well(pair.b.replies[0].state));
  }));
}

TEST(GroupStop, OtherMotionsContinue) {
  for (const std::uint64_t group : {std::uint64_t{0}, kStop.group + 1}) {
    Pair pair;
    ASSERT_FALSE(pair.a.send(Pair::command(pair.a, kVelocity, kStop)));
    ASSERT_FALSE(pair.b.send(Pair::command(pair.b, kVelocity, {kStop.ticks, 0, group})));
    pair.run(50);
    drive_fault(pair);
    pair.run(50);
    EXPECT_TRUE(pair.b.seen().desired.velocity.isApprox(kVelocity, 1e-9)) << group;
  }
}

TEST(GroupStop, EmergencyStopShortensAStopInStep) {
  for (const int before : {0, 1, 20}) {
    Pair pair;
    pair.move(kVelocity);
    pair.run(50);
    switched_off(pair);
    pair.run(before);
    emergency_stop(pair);
    const DesiredState from = pair.a.seen().desired;
    Stop own(pair.a.model.parameters(), kPeriod);
    own.plan(from);
    pair.run(static_cast<int>(own.ticks()));
    EXPECT_TRUE((pair.a.seen().desired.position - own.end().position).isZero(1e-9)) << before;
    pair.run(2);
    EXPECT_FALSE(pair.a.servo.drives_on()) << before;
  }
}

/// The first cause is reported, the stop is that of the urgent one.
TEST(GroupStop, UrgentReasonBesideAnotherMakesTheStopTheShortest) {
  for (const ErrorCode cause : {ErrorCode::io_fault, ErrorCode::bus_error}) {
    for (const bool urgent : {false, true}) {
      Pair pair;
      pair.move(kVelocity);
      pair.run(50);
      Stop own(pair.a.model.parameters(), kPeriod);
      own.plan(pair.a.seen().desired);
      pair.a.hardware.fault = cause;
      if (urgent) emergency_stop(pair);
      pair.run(1);
      EXPECT_EQ(pair.a.seen().fault.code, cause);
      EXPECT_EQ((pair.a.seen().end.position - own.end().position).isZero(1e-9), urgent);
    }
  }
}

TEST(GroupStop, RobotBeyondTheTableStopsAloneAtItsForceLimit) {
  Pair pair;
  pair.a.servo.use_group_stops(pair.stops, clock::GroupStops::kMaxRobots);
  pair.move(kVelocity);
  pair.run(50);
  force_limit(pair);
  pair.run(1);
  EXPECT_EQ(pair.a.seen().interruptions, 1u);
  pair.run(200);
  EXPECT_TRUE(pair.a.seen().desired.at_rest());
}

TEST(GroupStop, IsTheRobotsOwnWhereTheCommonOneWouldLeaveTheLimits) {
  for (const CommonStop stop : {CommonStop{10, 0, 7}, CommonStop{10'000, 0, 7}, CommonStop{0, 0, 7}}) {
    Pair pair;
    pair.move(velocity_of(0.6, 0.3, 0, 0), stop);
    pair.run(90);
    drive_fault(pair);
    pair.run(1);
    Stop own(pair.b.model.parameters(), kPeriod);
    own.plan(pair.b.seen().desired);
    for (std::uint32_t k = 1; k <= own.ticks(); ++k) {
      pair.run(1);
      EXPECT_TRUE((pair.b.seen().desired.position - own.at(k * kPeriod).position).isZero(1e-12)) << stop.ticks;
    }
    EXPECT_TRUE(pair.b.seen().desired.at_rest());
    EXPECT_EQ(pair.b.seen().fault.code, ErrorCode::none);
  }
}

TEST(GroupStop, ForceMotionsBrakeEachOnItsOwn) {
  Pair pair;
  RobotCommand push = force_command(0, 0.05);
  push.motion_steps = 400;
  push.stop = kStop;
  ASSERT_FALSE(pair.a.send(Pair::command(pair.a, kVelocity, kStop)));
  ASSERT_FALSE(pair.b.send(push));
  pair.run(60);
  EXPECT_FALSE(pair.b.seen().desired.at_rest());
  drive_fault(pair);
  pair.run(150);
  EXPECT_TRUE(pair.b.seen().desired.at_rest());
  EXPECT_TRUE(pair.b.seen().enabled());
}

TEST(GroupStop, RobotThatOnlyHoldsStopsTheOthers) {
  Pair pair;
  RobotCommand hold;
  hold.kind = CommandKind::hold;
  hold.motion_steps = 100;
  hold.stop = kStop;
  ASSERT_FALSE(pair.a.send(hold));
  ASSERT_FALSE(pair.b.send(Pair::command(pair.b, kVelocity, kStop)));
  pair.run(50);
  drive_fault(pair);
  pair.run(1 + kStop.ticks);
  EXPECT_TRUE(pair.b.seen().desired.at_rest());
}

}  // namespace
}  // namespace mrroc::edp::group_stop_test
