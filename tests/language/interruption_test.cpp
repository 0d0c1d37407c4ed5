// Interrupted Move and Wait: errors, pauses, late commands.
#include <gtest/gtest.h>

#include "language/drive.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::interruption_test {
namespace {

using fakes::Action;
using fakes::Call;
using fakes::Drive;
using fakes::FakeTask;

TEST(Interruption, MostSevereErrorOfAStepIsThrown) {
  FakeTask task;
  const auto left = task.robot("left");
  const auto right = task.robot("right");
  const auto gate = task.sensor("gate");
  task.robot_fake("left").errors[1] = {ErrorClass::non_fatal, ErrorCode::singular, {}};
  task.robot_fake("right").errors[1] = {ErrorClass::hardware, ErrorCode::drive_fault, {"axis 2"}};
  task.sensor_fake("gate").errors[1] = {ErrorClass::hardware, ErrorCode::sensor_hardware, {}};
  try {
    Wait({*left, *right}, {*gate}, ElapsedSteps{9});
    FAIL();
  } catch (const HardwareError& error) {
    EXPECT_STREQ(error.what(),
                 "hardware error: a drive reports a fault: axis 2 [process test, device right, step 1, tick 1010]");
  }
}

class MyError : public NonFatalError {
 public:
  MyError() : NonFatalError("mine") {}
};

TEST(Interruption, ErrorOfTheGeneratorKeepsItsTypeAndNamesItsOrigin) {
  FakeTask task;
  const auto arm = task.robot("arm");
  Drive drive({arm.get()});
  int steps = 0;
  drive.act = [&] {
    if (++steps == 3) throw MyError{};
  };
  try {
    Move({*arm}, {}, drive);
    FAIL();
  } catch (const MyError& error) {
    EXPECT_EQ(error.origin().process, "test");
    EXPECT_EQ(error.origin().step, 2u);
    EXPECT_EQ(error.origin().tick, 1018u);
    EXPECT_STREQ(error.what(), "non-fatal error: the task failed: mine [process test, step 2, tick 1018]");
  }
}

TEST(Interruption, ErrorOfALinkNamesItsStep) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.robot_fake("arm").throws[2] = [] { throw SystemError(ErrorCode::process_died, "arm_edp", {"", "arm", 0, 0}); };
  try {
    Move({*arm}, {}, Drive{{arm.get()}});
    FAIL();
  } catch (const SystemError& error) {
    EXPECT_STREQ(error.what(), "system error: a process died: arm_edp [process test, device arm, step 1, tick 1008]");
  }
}

TEST(Interruption, TaskMayContinueAfterAnError) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.robot_fake("arm").errors[1] = {ErrorClass::non_fatal, ErrorCode::out_of_workspace, {}};
  EXPECT_THROW(Move({*arm}, {}, Drive{{arm.get()}}), NonFatalError);
  EXPECT_EQ(Wait({*arm}, {}, ElapsedSteps{3}).steps, 3u);
}

TEST(Interruption, StopDuringAPauseEndsTheTask) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.requests = {OperatorRequest::pause, OperatorRequest::pause, OperatorRequest::stop};
  EXPECT_THROW(Move({*arm}, {}, Drive{{arm.get()}}), Stopped);
}

TEST(Interruption, EndMotionDuringAPauseEndsTheMotionWithoutResumingIt) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.requests = {OperatorRequest::none, OperatorRequest::pause, OperatorRequest::end_motion};
  class NoResume : public Drive {
   public:
    using Drive::Drive;
    void resume() override { FAIL(); }
  } drive({arm.get()});
  const Outcome end = Move({*arm}, {}, drive);
  EXPECT_EQ(end.ending, Ending::end_motion);
  EXPECT_EQ(end.steps, 1u);
}

/// Moves, and brakes on request within `steps` steps.
class Braking : public Drive {
 public:
  Braking(const std::vector<Robot*>& robots, int steps) : Drive(robots), steps_(steps), robots_(robots) {}
  bool brake() override {
    ++brakes;
    left_ = steps_;
    return true;
  }
  void resume() override {
    for (const Robot* robot : robots_) EXPECT_TRUE(robot->state().desired_velocity.isZero(0));
    ++resumes;
    left_ = -1;
  }
  void next_state() override {
    Drive::next_state();
    if (left_ > 0 && --left_ > 0) return;
    if (left_ == 0)
      for (Robot* robot : robots_) robot->command().joint_velocity.setZero();
  }
  int brakes = 0, resumes = 0;

 private:
  int steps_, left_ = -1;
  std::vector<Robot*> robots_;
};

TEST(Interruption, BrakingGeneratorComesToRestBeforeAPauseHolds) {
  for (const std::size_t pauses : {std::size_t{1}, std::size_t{3}, std::size_t{7}}) {
    FakeTask task;
    const auto arm = task.robot("arm");
    task.requests = {OperatorRequest::none, OperatorRequest::none};
    task.requests.insert(task.requests.end(), pauses, OperatorRequest::pause);
    Braking motion({arm.get()}, 3);
    const Outcome end = Move({*arm}, {}, motion.until(ElapsedSteps{8}));
    EXPECT_EQ(end.steps, 8u) << "braking takes steps, holding does not";
    EXPECT_EQ(motion.brakes, 1);
    EXPECT_EQ(motion.resumes, 1);
    std::size_t holds = 0;
    for (const Call& call : task.log.calls) holds += call.action == Action::send && call.kind == CommandKind::hold;
    EXPECT_EQ(holds, pauses > 3 ? pauses - 3 : 0) << "a pause of " << pauses;
  }
}

TEST(Interruption, StopWhileAGeneratorBrakesIsNotDelayed) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.requests = {OperatorRequest::none, OperatorRequest::pause, OperatorRequest::stop};
  Braking motion({arm.get()}, 100);
  EXPECT_THROW(Move({*arm}, {}, motion), Stopped);
  EXPECT_EQ(motion.resumes, 0);
}

TEST(Interruption, AfterALateCommandAllRobotsComeToRestAndTheGeneratorGoesOnFromThere) {
  FakeTask task;
  const auto left = task.robot("left");
  const auto right = task.robot("right");
  task.robot_fake("left").late_at = 3;  // the query's reply is number 0
  struct Resumed : Drive {
    using Drive::Drive;
    void resume() override {
      ++times;
      for (const Robot* robot : seen) EXPECT_TRUE(robot->state().desired_velocity.isZero(0));
    }
    int times = 0;
    std::vector<Robot*> seen;
  } drive({left.get(), right.get()});
  drive.seen = {left.get(), right.get()};
  const Outcome end = Move({*left, *right}, {}, drive.until(ElapsedSteps{6}));
  EXPECT_EQ(drive.times, 1);
  EXPECT_EQ(end.steps, 6u) << "holding is not a step";
  std::vector<CommandKind> kinds;
  for (const Call& call : task.log.calls)
    if (call.action == Action::send && call.device == "right") kinds.push_back(call.kind);
  const std::vector<CommandKind> expected{CommandKind::query, CommandKind::joint, CommandKind::joint,
                                          CommandKind::joint, CommandKind::hold,  CommandKind::joint,
                                          CommandKind::joint, CommandKind::joint};
  EXPECT_EQ(kinds, expected);
}

// they were requested for the tick at which the robot should have replied
TEST(Interruption, ReadingsAreNewWhenTheGeneratorPlansAgainAfterALateCommand) {
  FakeTask task;
  const auto arm = task.robot("arm");
  const auto gate = task.sensor("gate");
  task.robot_fake("arm").late_at = 3;
  task.robot_fake("arm").throws[3] = [&task] { task.robot_fake("arm").way = 30; };  // it throws nothing
  task.robot_fake("arm").throws[4] = [&task] { task.robot_fake("arm").way = 0; };
  struct AtRest : Generator {
    AtRest(Robot& robot, Sensor& sensor) : Generator("AtRest"), arm(&robot), gate(&sensor) {}
    void start() override {}
    void resume() override {
      ++resumes;
      EXPECT_TRUE(arm->state().at_rest());
      EXPECT_GE(gate->reading().tick, arm->state().tick);
    }
    bool terminal_condition() override { return false; }
    void next_state() override {
      arm->command().kind = CommandKind::joint;
      arm->command().joints = arm->state().desired_joints;
    }
    Robot* arm;
    Sensor* gate;
    int resumes = 0;
  } generator(*arm, *gate);
  const Outcome end = Move({*arm}, {*gate}, generator.until(ElapsedSteps{6}));
  EXPECT_EQ(generator.resumes, 1);
  EXPECT_EQ(end.steps, 6u);
}

// a robot at rest with a late hold would make the moving one brake, and cause a refusal of its next command
TEST(Interruption, LateRobotAtRestDoesNotDelayAMovingOne) {
  FakeTask task;
  const auto resting = task.robot("resting");
  const auto moving = task.robot("moving");
  Drive drive({moving.get()});
  drive.act = [&task] { task.robot_fake("resting").way = task.log.calls.size() > 20 ? 3 : 0; };
  const Outcome end = Move({*resting, *moving}, {}, drive.until(ElapsedSteps{8}));
  EXPECT_GT(end.skew, 0u) << "it was late";
  Tick expected = 0;
  for (const Call& call : task.log.calls) {
    if (call.action != Action::send || call.device != "moving" || call.kind != CommandKind::joint) continue;
    if (expected != 0) {
      EXPECT_EQ(call.tick, expected);
    }
    expected = call.tick + static_cast<Tick>(call.motion_steps);
  }
  EXPECT_NE(expected, 0u);
}

TEST(Interruption, RobotsReplyEarlierAfterALateCommand) {
  FakeTask task;
  const auto arm = task.robot("arm");
  arm->set_macrostep(10, 9);
  task.robot_fake("arm").late_at = 3;
  Drive drive({arm.get()});
  Move({*arm}, {}, drive.until(ElapsedSteps{6}));
  Move({*arm}, {}, drive.until(ElapsedSteps{2}));
  std::vector<int> replies;
  for (const Call& call : task.log.calls)
    if (call.action == Action::send && call.kind == CommandKind::joint) replies.push_back(call.reply_step);
  EXPECT_EQ(replies, (std::vector<int>{9, 9, 9, 6, 6, 6, 9, 9})) << "for the rest of the Move";
}

// with a fixed margin, the robots would restart repeatedly on a machine that is slower than the margin
TEST(Interruption, RobotsGetMoreTimeForACommonStartUntilTheyStartTogether) {
  FakeTask task;
  const auto left = task.robot("left");
  const auto right = task.robot("right");
  for (Robot* robot : {left.get(), right.get()}) robot->set_macrostep(10, 11);  // every step ends at rest
  task.robot_fake("right").way = 9;
  EXPECT_EQ(Wait({*left, *right}, {}, ElapsedSteps{6}).skew, 7u) << "of the first start, 9 ticks after 2";
  std::vector<Tick> starts;
  for (const Call& call : task.log.calls)
    if (call.action == Action::send && call.device == "left" && call.kind == CommandKind::hold)
      starts.push_back(call.tick);
  // with margins of 2, 4, 8 and 16 ticks; from there on both start at the commanded tick
  EXPECT_EQ(starts, (std::vector<Tick>{1002, 1024, 1048, 1076, 1103, 1130}));
}

}  // namespace
}  // namespace mrroc::interruption_test
