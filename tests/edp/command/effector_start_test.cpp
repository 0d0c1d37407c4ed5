// When macrosteps and holds of the effector begin and end.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

#include "edp/command/cruise.hpp"
#include "edp/command/effector.hpp"

namespace mrroc::edp::effector_start_test {
namespace {

/// The servo's thread ticks while the other one plans.
class Overtaken : public Slide {
 public:
  ErrorCode inverse(const Pose& pose, const JointVector& near, JointVector& joints) const noexcept override {
    if (meanwhile) std::exchange(meanwhile, {})();
    return Slide::inverse(pose, near, joints);
  }
  mutable std::function<void()> meanwhile;
};

TEST(Effector, DelayedStartDelaysTheEndInEveryAnswer) {
  for (const bool waiting : {false, true}) {  // a successor, before the first reply
    Rig<Overtaken> rig;
    rig.run(3);
    RobotCommand command;
    command.kind = CommandKind::pose;
    command.pose = Pose(Eigen::Translation3d(0.26, 0, 0));
    command.motion_steps = 100;
    command.reply_step = 90;
    rig.model.meanwhile = [&rig] { rig.tick(); };
    ASSERT_FALSE(rig.send(command));
    if (waiting) {
      ASSERT_FALSE(rig.send(command));
    }
    while (rig.replies.empty()) rig.tick();
    const RobotState first = rig.replies[0].state;
    EXPECT_EQ(first.desired_tick, first.macrostep_start + 100);
    EXPECT_EQ(first.macrostep_start, 4u) << "3 was planned, and 4 had begun";
    if (!waiting) {
      EXPECT_EQ(rig.query().desired_tick, first.desired_tick);
      continue;
    }
    EXPECT_EQ(rig.query().desired_tick, first.desired_tick + 100);
    while (rig.replies.size() < 2) rig.tick();
    EXPECT_EQ(rig.replies[1].state.macrostep_start, first.desired_tick);
    EXPECT_EQ(rig.query().desired_tick, rig.replies[1].state.desired_tick);
  }
}

TEST(Effector, StartTickIsKept) {
  Rig<Slide> rig;
  RobotCommand command = joint_command(one(0.3), 100, 10);
  command.start_tick = 40;
  const double home = rig.seen().desired.position[0];
  ASSERT_FALSE(rig.send(command));
  rig.run(40);
  EXPECT_EQ(rig.seen().tick, 40u);
  EXPECT_EQ(rig.seen().desired.position[0], home);
  rig.tick();
  EXPECT_GT(rig.seen().desired.position[0], home);
  rig.run(20);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.tick, 50u);
  EXPECT_EQ(rig.replies[0].state.desired_tick, 140u);
  command.start_tick = 1'000'000;
  EXPECT_TRUE(rig.send(command));
  EXPECT_EQ(rig.answer.state.error.code, ErrorCode::invalid_argument);
}

TEST(Effector, StartTickAfterTheEndOfAMotionLetsTheRobotStopFirst) {
  Rig<Slide> rig;
  run_up(rig);
  RobotCommand command = joint_command(one(0.6), 300, 300);
  command.start_tick = 400;
  ASSERT_FALSE(rig.send(command));
  rig.run(150);
  EXPECT_EQ(rig.seen().desired.velocity[0], 0);
  rig.run(600);
  EXPECT_EQ(rig.effector.counters().late, 0u);
  EXPECT_EQ(rig.seen().desired.position[0], 0.6);
  ASSERT_EQ(rig.replies.size(), 1u);
  EXPECT_EQ(rig.replies[0].state.tick, 700u);
}

TEST(Effector, HoldShorterThanItsStopIsContinuedOrReplaced) {
  for (const bool continued : {true, false}) {
    Rig<Slide> rig;
    run_up(rig);
    RobotCommand hold;
    hold.kind = CommandKind::hold;
    ASSERT_FALSE(rig.send(hold));
    rig.run(10);
    ASSERT_EQ(rig.replies.size(), 1u);
    EXPECT_NE(rig.replies[0].state.desired_velocity[0], 0) << "N = 10 ticks of a stop of 33";
    EXPECT_EQ(rig.replies[0].state.desired_tick, rig.replies[0].state.tick + 2);
    if (continued) {
      ASSERT_FALSE(rig.send(hold));
    }
    rig.run(200);
    const double rest = rig.seen().desired.position[0];
    EXPECT_TRUE(rig.seen().desired.at_rest());
    EXPECT_EQ(rig.effector.counters().late, 0u);
    EXPECT_EQ(rig.seen().counters.stops, 0u);

    Rig<Slide> whole;
    run_up(whole);
    hold.motion_steps = 200;
    ASSERT_FALSE(whole.send(hold));
    whole.run(250);
    EXPECT_NEAR(rest, whole.seen().desired.position[0], 1e-9) << "the same stop, in parts";
  }
}

TEST(Effector, HoldComesToRestAndStays) {
  Rig<Slide> rig;
  run_up(rig);
  RobotCommand hold;
  hold.kind = CommandKind::hold;
  hold.motion_steps = 10;
  hold.reply_step = 11;
  ASSERT_FALSE(rig.send(hold));
  rig.run(200);
  ASSERT_EQ(rig.replies.size(), 1u);  // the macrostep lasts as long as the stop: 33 ticks
  EXPECT_NEAR(static_cast<double>(rig.replies[0].state.tick), 234, 1);
  EXPECT_EQ(rig.replies[0].state.desired_velocity[0], 0);
  EXPECT_EQ(rig.effector.counters().late, 0u);
  EXPECT_EQ(rig.seen().counters.stops, 0u);
  ASSERT_FALSE(rig.send(hold));
  const Tick sent = rig.seen().tick;
  rig.run(20);
  EXPECT_EQ(rig.replies.at(1).state.tick, sent + 11);
}

}  // namespace
}  // namespace mrroc::edp::effector_start_test
