// Examples of Move and Wait that the random scripts do not cover.
#include <gtest/gtest.h>

#include "language/drive.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/move.hpp"

namespace mrroc::instruction_test {
namespace {

using fakes::Action;
using fakes::Call;
using fakes::Drive;
using fakes::FakeTask;

template <class Act>
ErrorCode code_of(Act&& act) {
  try {
    act();
  } catch (const NonFatalError& error) {
    return error.code();
  }
  return ErrorCode::none;
}

std::vector<Tick> start_ticks(const FakeTask& task, const std::string& robot) {
  std::vector<Tick> ticks;
  for (const Call& call : task.log.calls) {
    if (call.action == Action::send && call.device == robot && call.kind != CommandKind::query)
      ticks.push_back(call.tick);
  }
  return ticks;
}

TEST(Instruction, RefusesInvalidLists) {
  FakeTask task;
  FakeTask other;
  const auto arm = task.robot("arm");
  const auto again = task.robot("arm");
  const auto unknown = other.robot("arm2");
  const auto gate = task.sensor("gate");
  const auto gate_again = task.sensor("gate");
  const auto strange_gate = other.sensor("gate2");
  const auto refused = [](const RobotList& robots, const SensorList& sensors) {
    return code_of([&] { Wait(robots, sensors, ElapsedSteps{0}); }) == ErrorCode::invalid_argument &&
           code_of([&] { Move(robots, sensors, Drive{{}}); }) == ErrorCode::invalid_argument;
  };
  EXPECT_TRUE(refused({}, {}));
  EXPECT_TRUE(refused({*arm, *arm}, {}));
  EXPECT_TRUE(refused({*arm, *again}, {}));
  EXPECT_TRUE(refused({*arm}, {*gate, *gate}));
  EXPECT_TRUE(refused({*arm}, {*gate, *gate_again}));
  EXPECT_TRUE(refused({*arm, *unknown}, {}));
  EXPECT_TRUE(refused({*arm}, {*strange_gate}));
  EXPECT_TRUE(refused(RobotList{std::vector<Robot*>{nullptr}}, {}));
  EXPECT_TRUE(refused({*arm}, SensorList{std::vector<Sensor*>{gate.get(), nullptr}}));
  EXPECT_EQ(code_of([&] { Wait({*arm}, {}, std::shared_ptr<Condition>{}); }), ErrorCode::invalid_argument);
  EXPECT_TRUE(task.log.calls.empty());

  EXPECT_FALSE(refused({*arm}, {*gate}));
  EXPECT_FALSE(refused({}, {*gate}));
}

TEST(Instruction, RefusalNamesTheRepeatedRobot) {
  FakeTask task;
  const auto arm = task.robot("arm");
  try {
    Wait({*arm, *arm}, {}, ElapsedSteps{0});
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_STREQ(error.what(), "non-fatal error: invalid argument: 'arm' is listed twice [process test, device arm]");
  }
}

TEST(Instruction, RestingRobotsGetTimeForTheirCommandsAtEveryCommonStart) {
  FakeTask task;
  const auto left = task.robot("left");
  const auto right = task.robot("right");
  for (Robot* robot : {left.get(), right.get()}) robot->set_macrostep(10, 11);  // every step ends at rest
  Wait({*left, *right}, {}, ElapsedSteps{2});
  EXPECT_EQ(start_ticks(task, "left"), (std::vector<Tick>{1002, 1015}));
  EXPECT_EQ(start_ticks(task, "right"), (std::vector<Tick>{1002, 1015}));
}

TEST(Instruction, MovingRobotsContinueWithoutABreakInTheNextMove) {
  FakeTask task;
  const auto left = task.robot("left");
  const auto right = task.robot("right");
  Drive drive({left.get(), right.get()});
  drive.until(ElapsedSteps{2});
  Move({*left, *right}, {}, drive);
  Move({*left, *right}, {}, drive);
  EXPECT_EQ(start_ticks(task, "left"), (std::vector<Tick>{1002, 1012, 1022, 1032}));
  EXPECT_EQ(start_ticks(task, "right"), start_ticks(task, "left"));
}

/// At step k, commands the robots whose bit is set in k; the others get no command.
class InTurns : public Generator {
 public:
  explicit InTurns(std::vector<Robot*> robots) : Generator("in turns"), robots_(std::move(robots)) {}
  bool terminal_condition() override { return step_ == (1u << robots_.size()); }
  void next_state() override {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if ((step_ >> i & 1u) == 0) continue;
      robots_[i]->command().kind = CommandKind::joint;
      robots_[i]->command().joints = robots_[i]->state().desired_joints;
    }
    ++step_;
  }
  void start() override { step_ = 0; }

 private:
  std::vector<Robot*> robots_;
  unsigned step_ = 0;
};

// original's defect 4: robots that needed no command were erased from the list during an iteration over it
TEST(Instruction, RobotsThatAreNotCommandedAtAStepStayInTheList) {
  FakeTask task;
  const auto left = task.robot("left"), middle = task.robot("middle"), right = task.robot("right");
  const RobotList robots{*left, *middle, *right};
  InTurns generator({left.get(), middle.get(), right.get()});
  for (int i = 0; i < 2; ++i) {
    task.log.calls.clear();
    EXPECT_EQ(Move(robots, {}, generator).steps, 8u);
    std::map<std::string, std::vector<bool>> commanded;
    std::map<std::string, int> answered;
    for (const Call& call : task.log.calls) {
      if (call.action == Action::receive) ++answered[call.device];
      if (call.action != Action::send || call.kind == CommandKind::query) continue;
      commanded[call.device].push_back(call.kind == CommandKind::joint);
      EXPECT_TRUE(call.kind == CommandKind::joint || call.kind == CommandKind::hold);
    }
    EXPECT_EQ(commanded["left"], (std::vector<bool>{0, 1, 0, 1, 0, 1, 0, 1}));
    EXPECT_EQ(commanded["middle"], (std::vector<bool>{0, 0, 1, 1, 0, 0, 1, 1}));
    EXPECT_EQ(commanded["right"], (std::vector<bool>{0, 0, 0, 0, 1, 1, 1, 1}));
    for (const char* name : {"left", "middle", "right"}) EXPECT_EQ(answered[name], 9) << name;
  }
}

// original's defect 19: the skew between robots was neither measured nor known
TEST(Instruction, TheOutcomeTellsHowFarApartTheRobotsBeganTheirMacrosteps) {
  for (const Tick delay : {0, 2}) {
    FakeTask task;
    const auto left = task.robot("left"), right = task.robot("right");
    task.robot_fake("right").delayed_start = delay;
    const Outcome outcome = Move({*left, *right}, {}, Hold(*left, 0.1));
    EXPECT_GT(outcome.steps, 0u);
    EXPECT_EQ(outcome.skew, delay);
  }
}

TEST(Instruction, StartTickOfTheGeneratorIsKept) {
  FakeTask task;
  const auto left = task.robot("left");
  const auto right = task.robot("right");
  Drive drive({left.get(), right.get()});
  drive.until(ElapsedSteps{1});
  drive.act = [&] { right->command().start_tick = 2000; };
  Move({*left, *right}, {}, drive);
  EXPECT_EQ(start_ticks(task, "left"), std::vector<Tick>{1002});
  EXPECT_EQ(start_ticks(task, "right"), std::vector<Tick>{2000});
}

TEST(Instruction, ReadingHasTheTickOfItsState) {
  FakeTask task;
  const auto arm = task.robot("arm");
  const auto wrist = task.sensor("wrist");
  Wait({*arm}, {*wrist}, When{"same tick", [&, steps = 0]() mutable {
                                EXPECT_EQ(arm->state().tick, wrist->reading().tick);
                                return ++steps == 5;
                              }});
}

TEST(Instruction, ReadingHasTheTickOfItsStateAlsoAfterSlowPlanning) {
  FakeTask task;
  const auto arm = task.robot("arm");
  const auto wrist = task.sensor("wrist");
  Drive drive({arm.get()}, 0);
  drive.act = [&] { task.time.tick += 5; };
  drive.until(When{"same tick", [&, steps = 0]() mutable {
                     EXPECT_EQ(arm->state().tick, wrist->reading().tick);
                     return ++steps == 5;
                   }});
  Move({*arm}, {*wrist}, drive);
}

TEST(Instruction, StepLastsTenTicksWithoutRobots) {
  FakeTask task;
  const auto gate = task.sensor("gate", false);
  const Outcome end = Wait({}, {*gate}, ElapsedSteps{3});
  EXPECT_EQ(end.start_tick, 1000u);
  EXPECT_EQ(end.end_tick, 1030u);
  EXPECT_DOUBLE_EQ(end.duration, 0.06);
}

}  // namespace
}  // namespace mrroc::instruction_test
