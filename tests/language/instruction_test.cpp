// Examples of Move and Wait that the random scripts do not reach.
#include <gtest/gtest.h>

#include "language/fakes.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/generators/hold.hpp"
#include "mrroc/move.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc {
namespace {

using fakes::Action;
using fakes::Call;
using fakes::FakeTask;

/// Commands `velocity` at the end of every macrostep to its robots, and does what `act` says at the first step.
class Drive : public Generator {
 public:
  explicit Drive(std::vector<Robot*> robots, double velocity = 0.1)
      : Generator("drive"), robots_(std::move(robots)), velocity_(velocity) {}
  void next_state() override {
    if (act) act();
    for (Robot* robot : robots_) {
      robot->command().kind = CommandKind::joint;
      robot->command().joints = robot->state().desired_joints;
      robot->command().joint_velocity = JointVector::Constant(robot->state().joints.size(), velocity_);
    }
  }
  std::function<void()> act;

 private:
  std::vector<Robot*> robots_;
  double velocity_;
};

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
    if (call.action == Action::send && call.who == robot && call.kind != CommandKind::query) ticks.push_back(call.tick);
  }
  return ticks;
}

TEST(Instruction, RefusesListsThatMakeNoSense) {
  FakeTask task;
  FakeTask other;
  const auto arm = task.robot("arm");
  const auto again = task.robot("arm");
  const auto stranger = other.robot("arm2");
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
  EXPECT_TRUE(refused({*arm, *stranger}, {}));
  EXPECT_TRUE(refused({*arm}, {*strange_gate}));
  EXPECT_TRUE(refused(RobotList{std::vector<Robot*>{nullptr}}, {}));
  EXPECT_TRUE(refused({*arm}, SensorList{std::vector<Sensor*>{gate.get(), nullptr}}));
  EXPECT_EQ(code_of([&] { Wait({*arm}, {}, std::shared_ptr<Condition>{}); }), ErrorCode::invalid_argument);
  EXPECT_TRUE(task.log.calls.empty());

  EXPECT_FALSE(refused({*arm}, {*gate}));
  EXPECT_FALSE(refused({}, {*gate}));
}

TEST(Instruction, TheRefusalNamesWhatStandsTwice) {
  FakeTask task;
  const auto arm = task.robot("arm");
  try {
    Wait({*arm, *arm}, {}, ElapsedSteps{0});
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_STREQ(error.what(),
                 "non-fatal error: invalid argument: 'arm' stands twice in the list [process test, device arm]");
  }
}

/// Keeps what it is shown.
class Recorder : public StepObserver {
 public:
  struct Seen {
    bool is_move, last;
    std::uint64_t instruction, step;
    std::string name;
    Tick tick;
    std::size_t robots, sensors;
    std::vector<std::string> conditions;
    std::vector<bool> values;
  };
  void on_step(const StepRecord& record) noexcept override {
    seen.push_back({record.is_move,
                    record.last,
                    record.instruction,
                    record.step,
                    *record.name,
                    record.tick,
                    record.robots.size(),
                    record.sensors.size(),
                    {},
                    {}});
    for (const Condition* condition : record.conditions) {
      seen.back().conditions.push_back(condition->name());
      seen.back().values.push_back(condition->value());
    }
  }
  std::vector<Seen> seen;
};

TEST(Instruction, TheObserverSeesEveryStepAndInstructionsAreCounted) {
  FakeTask task;
  Recorder recorder;
  task.step_observer = &recorder;
  const auto arm = task.robot("arm");
  const auto gate = task.sensor("gate");
  Wait({*arm}, {*gate}, ElapsedSteps{1} && When{"yes", [] { return true; }});
  EXPECT_THROW(Wait({}, {}, ElapsedSteps{0}), NonFatalError);  // refused: not an instruction
  Move({*arm}, {}, Drive{{arm.get()}}.until(ElapsedSteps{0}));
  ASSERT_EQ(recorder.seen.size(), 3u);
  const auto& first = recorder.seen[0];
  EXPECT_FALSE(first.is_move);
  EXPECT_FALSE(first.last);
  EXPECT_EQ(first.name, "elapsed 1 steps and yes");
  EXPECT_EQ(first.instruction, 1u);
  EXPECT_EQ(first.tick, 1000u);
  EXPECT_EQ(first.robots, 1u);
  EXPECT_EQ(first.sensors, 1u);
  EXPECT_EQ(first.conditions, (std::vector<std::string>{"elapsed 1 steps", "yes"}));
  EXPECT_EQ(first.values, (std::vector<bool>{false, true}));
  EXPECT_TRUE(recorder.seen[1].last);
  EXPECT_EQ(recorder.seen[1].step, 1u);
  EXPECT_EQ(recorder.seen[1].tick, 1008u);
  EXPECT_TRUE(recorder.seen[2].is_move);
  EXPECT_TRUE(recorder.seen[2].last);
  EXPECT_EQ(recorder.seen[2].name, "drive");
  EXPECT_EQ(recorder.seen[2].instruction, 2u);
}

TEST(Instruction, AtAnEndMotionNoValuesAreShownThatWereNotEvaluated) {
  FakeTask task;
  Recorder recorder;
  task.step_observer = &recorder;
  task.requests = {OperatorRequest::none, OperatorRequest::end_motion};
  const auto arm = task.robot("arm");
  const Outcome end = Wait({*arm}, {}, When{"never", [] { return false; }});
  EXPECT_EQ(end.reason(), "end of motion");
  EXPECT_EQ(end.condition, nullptr);
  ASSERT_EQ(recorder.seen.size(), 2u);
  EXPECT_EQ(recorder.seen[0].conditions.size(), 1u);
  EXPECT_TRUE(recorder.seen[1].conditions.empty());
}

TEST(Instruction, TheObserverIsCalledBetweenTheTwoEndsOfTheExchange) {
  FakeTask task;
  class Marker : public StepObserver {
   public:
    explicit Marker(fakes::CallLog& log) : log_(log) {}
    void on_step(const StepRecord&) noexcept override { log_.add({.action = Action::observe, .who = ""}); }

   private:
    fakes::CallLog& log_;
  } marker(task.log);
  task.step_observer = &marker;
  const auto left = task.robot("left");
  const auto right = task.robot("right");
  Wait({*left, *right}, {}, ElapsedSteps{1});
  std::vector<Action> actions;
  for (const Call& call : task.log.calls) actions.push_back(call.action);
  EXPECT_EQ(actions, (std::vector<Action>{Action::send, Action::send, Action::receive, Action::receive,  // the GET
                                          Action::ask_operator, Action::send, Action::send, Action::observe,
                                          Action::receive, Action::receive, Action::ask_operator, Action::observe}));
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

TEST(Instruction, MovingRobotsGoOnWithoutABreakFromOneMoveToTheNext) {
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

/// At step k, commands the robots whose bit is set in k; the others are left as they are.
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

// original's defect 4: robots that needed no command were erased from the list while it was being gone through
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
      if (call.action == Action::receive) ++answered[call.who];
      if (call.action != Action::send || call.kind == CommandKind::query) continue;
      commanded[call.who].push_back(call.kind == CommandKind::joint);
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

TEST(Instruction, AStartTickGivenByTheGeneratorStays) {
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

TEST(Instruction, AReadingIsOfTheTickOfTheStateItIsSeenWith) {
  FakeTask task;
  const auto arm = task.robot("arm");
  const auto wrist = task.sensor("wrist");
  Wait({*arm}, {*wrist}, When{"same tick", [&, steps = 0]() mutable {
                                EXPECT_EQ(arm->state().tick, wrist->reading().tick);
                                return ++steps == 5;
                              }});
}

TEST(Instruction, AReadingIsOfTheTickOfTheStateAlsoWhenPlanningTookTime) {
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

TEST(Instruction, TheGravestErrorOfAStepIsThrown) {
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

TEST(Instruction, AnErrorOfTheGeneratorKeepsItsTypeAndSaysWhere) {
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

TEST(Instruction, AnErrorOfALinkSaysAtWhichStep) {
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

TEST(Instruction, AfterAnErrorTheTaskMayGoOn) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.robot_fake("arm").errors[1] = {ErrorClass::non_fatal, ErrorCode::out_of_workspace, {}};
  EXPECT_THROW(Move({*arm}, {}, Drive{{arm.get()}}), NonFatalError);
  EXPECT_EQ(Wait({*arm}, {}, ElapsedSteps{3}).steps, 3u);
}

TEST(Instruction, AStopDuringAPauseLeavesTheTask) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.requests = {OperatorRequest::pause, OperatorRequest::pause, OperatorRequest::stop};
  EXPECT_THROW(Move({*arm}, {}, Drive{{arm.get()}}), Stopped);
}

TEST(Instruction, AnEndMotionDuringAPauseEndsTheMotionWithoutResumingIt) {
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

TEST(Instruction, AfterALateCommandAllRobotsComeToRestAndTheGeneratorGoesOnFromThere) {
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
  EXPECT_EQ(end.steps, 6u) << "holding is no step";
  std::vector<CommandKind> kinds;
  for (const Call& call : task.log.calls)
    if (call.action == Action::send && call.who == "right") kinds.push_back(call.kind);
  const std::vector<CommandKind> expected{CommandKind::query, CommandKind::joint, CommandKind::joint,
                                          CommandKind::joint, CommandKind::hold,  CommandKind::joint,
                                          CommandKind::joint, CommandKind::joint};
  EXPECT_EQ(kinds, expected);
}

TEST(Instruction, WithoutRobotsAStepLastsTenTicks) {
  FakeTask task;
  const auto gate = task.sensor("gate", false);
  const Outcome end = Wait({}, {*gate}, ElapsedSteps{3});
  EXPECT_EQ(end.start_tick, 1000u);
  EXPECT_EQ(end.end_tick, 1030u);
  EXPECT_DOUBLE_EQ(end.duration, 0.06);
}

}  // namespace
}  // namespace mrroc
