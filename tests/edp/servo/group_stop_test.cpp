// Robots that share a motion: where one of them stops alone, the others stop, too.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "edp/force/force_rig.hpp"
#include "edp/random_values.hpp"
#include "language/stops/common_stop_path.hpp"

namespace mrroc::edp::group_stop_test {
namespace {

constexpr CommonStop kStop{200, 0, 7};

/// Two robots of one computer, in step.
struct Pair {
  explicit Pair(bool second_first = false) : order_{second_first ? &b : &a, second_first ? &a : &b} {
    a.servo.use_group_stops(stops, 0);
    b.servo.use_group_stops(stops, 1);
  }

  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      order_[0]->tick();
      order_[1]->tick();
    }
  }
  /// Both begin a macrostep of 100 ticks that ends in motion.
  void move(const JointVector& velocity, const CommonStop& stop = kStop) {
    for (GantryBeforeWall* rig : {&a, &b}) ASSERT_FALSE(rig->send(command(*rig, velocity, stop)));
  }
  static RobotCommand command(const GantryBeforeWall& rig, const JointVector& velocity, const CommonStop& stop) {
    const double way = rig.seen().end.at_rest() ? 0.1 : 0.2;
    RobotCommand command = joint_command(rig.seen().end.position + way * velocity, 100, 100);
    command.joint_velocity = velocity;
    command.joint_acceleration = JointVector::Zero(velocity.size());
    command.stop = stop;
    return command;
  }

  clock::GroupStops stops;
  GantryBeforeWall a, b;

 private:
  std::array<GantryBeforeWall*, 2> order_;
};

JointVector velocity_of(double x, double y, double z, double yaw) {
  return (JointVector(4) << x, y, z, yaw).finished();
}

const JointVector kVelocity = velocity_of(-0.1, 0.2, 0.05, 0.1);

using Break = void (*)(Pair&);
void drive_fault(Pair& pair) { pair.a.hardware.fault = ErrorCode::drive_fault; }
void drives_lost(Pair& pair) { pair.a.hardware.positions_lost = true; }
void emergency_stop(Pair& pair) { pair.a.operators.press(); }
void switched_off(Pair& pair) { pair.a.effector.enable(false); }
void force_limit(Pair& pair) { pair.a.sensor.extra[1] = 200; }
void blind_sensor(Pair& pair) { pair.a.sensor.error = ErrorCode::hardware_silent; }

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

TEST(GroupStop, ImpactInTheLastTickOfAMotionIsReported) {
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

TEST(GroupStop, RobotWithoutASuccessorStopsTheOthers) {
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

TEST(GroupStop, CommandsOfAMotionThatIsGivenUpHold) {
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

/// At the end of a motion, which the next one of a single robot continues; not long before.
TEST(GroupStop, RobotThatContinuesInAnotherMotionIsLeftAlone) {
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
TEST(GroupStop, CommandThatWouldHaveContinuedTheMotionIsLate) {
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

/// The motion ends in the tick of the impact, and another one has been commanded.
TEST(GroupStop, ImpactAtTheBoundaryOfTwoMotionsStopsTheSecondOne) {
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

TEST(GroupStop, ImpactBeforeAFaultIsNotReportedAfterTheRecovery) {
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
