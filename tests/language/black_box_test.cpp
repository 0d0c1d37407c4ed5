// The last steps of a task in an error, compared with the states and commands of the task itself.
#include "mrroc/black_box.hpp"

#include <deque>

#include "language/drive.hpp"
#include "language/property.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"
#include "mrroc/stopped.hpp"

namespace mrroc::black_box_test {
namespace {

using fakes::Drive;
using fakes::FakeTask;

/// State and command of a generator at a step.
struct Witnessed {
  std::string robot;
  Tick tick = 0;
  double desired = 0, commanded = 0;
};

/// Commands the number of the command to all its robots, and records it.
class Witness : public Generator {
 public:
  Witness(std::vector<Robot*> robots, std::deque<std::vector<Witnessed>>& steps, double& count, std::uint64_t length)
      : Generator("witness " + std::to_string(robots.size())),
        robots_(std::move(robots)),
        steps_(steps),
        count_(count),
        length_(length) {}
  void start() override { done_ = 0; }
  bool terminal_condition() override {
    if (done_ < length_) return false;
    note(0);
    return true;
  }
  void next_state() override {
    ++done_;
    count_ += 1;
    for (Robot* robot : robots_) {
      robot->command().kind = CommandKind::joint;
      robot->command().joints = JointVector::Constant(2, count_);
    }
    note(count_);
  }

 private:
  void note(double commanded) {
    std::vector<Witnessed>& step = steps_.emplace_back();
    for (const Robot* robot : robots_)
      step.push_back({robot->name(), robot->state().tick, robot->state().desired_joints[0], commanded});
    if (steps_.size() > BlackBox::kSteps) steps_.pop_front();
  }

  std::vector<Robot*> robots_;
  std::deque<std::vector<Witnessed>>& steps_;
  double& count_;
  std::uint64_t length_;
  std::uint64_t done_ = 0;
};

void expect_witnessed(const BlackBox& box, const std::deque<std::vector<Witnessed>>& steps) {
  RC_ASSERT(box.size() == steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const StepRecord& record = box.at(i);
    RC_ASSERT(record.states.size() == steps[i].size());
    RC_ASSERT(record.instruction->name == "witness " + std::to_string(steps[i].size()));
    for (std::size_t k = 0; k < steps[i].size(); ++k) {
      const Witnessed& seen = steps[i][k];
      RC_ASSERT(record.instruction->robots.at(k) == seen.robot);
      RC_ASSERT(record.states[k].tick == seen.tick);
      RC_ASSERT(record.states[k].desired_joints[0] == seen.desired);
      RC_ASSERT(record.last() == (seen.commanded == 0));
      if (!record.last()) RC_ASSERT(record.commands.at(k).joints[0] == seen.commanded);
    }
    RC_ASSERT(record.commands.size() == (record.last() ? 0 : record.states.size()));
    if (i == 0) continue;
    const StepRecord& before = box.at(i - 1);
    const bool goes_on = record.instruction == before.instruction;
    RC_ASSERT(goes_on == !before.last());
    RC_ASSERT(record.step == (goes_on ? before.step + 1 : 0));
    RC_ASSERT(record.instruction->number == before.instruction->number + (goes_on ? 0 : 1));
  }
}

TEST(BlackBox, HoldsTheLastFiftyStepsOfAnyMoves) {
  fakes::check_property(200, [] {
    FakeTask task;
    task.log.recording = false;
    std::vector<std::unique_ptr<Robot>> robots;
    for (const char* name : {"a", "b", "c"}) robots.push_back(task.robot(name, 2));
    std::deque<std::vector<Witnessed>> steps;
    double count = 0;
    const auto moves = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(1, 8), rc::gen::inRange(0, 40)));
    RC_TAG(moves.size() > 5 ? "many moves" : "few moves");
    for (const auto& [team, length] : moves) {
      std::vector<Robot*> list;
      for (std::size_t i = 0; i < robots.size(); ++i)
        if ((team >> i) % 2 == 1) list.push_back(robots[i].get());
      Witness witness(list, steps, count, static_cast<std::uint64_t>(length));
      Move(RobotList{list}, {}, witness);
      expect_witnessed(task.black_box(), steps);
    }
  });
}

TEST(BlackBox, IsEmptyBeforeTheFirstStep) {
  FakeTask task;
  EXPECT_TRUE(task.black_box().empty());
  EXPECT_THROW(task.black_box().at(0), std::out_of_range);
  EXPECT_THROW(task.black_box().newest(), std::out_of_range);
}

TEST(BlackBox, ErrorContainsTheStateThatReportsIt) {
  FakeTask task;
  const auto arm = task.robot("arm"), belt = task.robot("belt");
  const auto wrist = task.sensor("wrist");
  task.robot_fake("belt").errors[70] = {ErrorClass::hardware, ErrorCode::drive_fault, {"axis 1"}};
  try {
    Wait({*arm, *belt}, {*wrist}, ElapsedSteps{100});
    FAIL();
  } catch (const HardwareError& error) {
    ASSERT_NE(error.black_box(), nullptr);
    const BlackBox& box = *error.black_box();
    EXPECT_EQ(box.size(), BlackBox::kSteps);
    EXPECT_EQ(box.recorded(), 71U) << "steps 0 to 70";
    const StepRecord& last = box.newest();
    EXPECT_EQ(last.ending, StepEnding::hardware_error);
    EXPECT_EQ(last.step, error.origin().step);
    EXPECT_EQ(last.tick, error.origin().tick);
    EXPECT_EQ(last.instruction->robots, (std::vector<std::string>{"arm", "belt"}));
    EXPECT_EQ(last.states.at(0).error.code, ErrorCode::none);
    EXPECT_EQ(last.states.at(1).error.code, ErrorCode::drive_fault);
    EXPECT_EQ(last.states.at(1).error.detail.view(), "axis 1");
    EXPECT_EQ(last.readings.at(0).values[0], 70) << "with the readings";
    EXPECT_TRUE(last.commands.empty());
    EXPECT_EQ(box.at(0).step, 21U);
    EXPECT_EQ(box.at(0).instruction->conditions, (std::vector<std::string>{"elapsed 100 steps"}));
    EXPECT_EQ(box.at(0).conditions, (std::vector<std::uint8_t>{0}));
  }
}

TEST(BlackBox, BoxOfAnErrorDoesNotChangeWhileTheTaskContinues) {
  FakeTask task;
  const auto arm = task.robot("arm");
  std::shared_ptr<const BlackBox> kept;
  Drive drive({arm.get()});
  drive.act = [] { throw NonFatalError("no part"); };
  try {
    Move({*arm}, {}, drive);
  } catch (const NonFatalError& error) {
    kept = error.black_box();
  }
  ASSERT_NE(kept, nullptr);
  const Tick then = kept->newest().tick;
  Wait({*arm}, {}, ElapsedSteps{200});
  EXPECT_EQ(kept->size(), 1U);
  EXPECT_EQ(kept->newest().tick, then);
  EXPECT_EQ(kept->newest().instruction->name, "drive");
  EXPECT_EQ(kept->newest().ending, StepEnding::non_fatal_error);
  EXPECT_EQ(task.black_box().recorded(), 202U);
  EXPECT_EQ(task.black_box().newest().instruction->name, "elapsed 200 steps");
}

TEST(BlackBox, ErrorOutsideAnInstructionHasNone) {
  FakeTask task;
  const auto arm = task.robot("arm");
  Wait({*arm}, {}, ElapsedSteps{3});
  EXPECT_EQ(NonFatalError("mine").black_box(), nullptr);
  try {
    Wait({*arm, *arm}, {}, ElapsedSteps{3});
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.black_box(), nullptr) << "it was refused before its start";
  }
}

// like fibers: each has its own robots, and they take turns
TEST(BlackBox, ParallelInstructionsKeepTheirOwnRobotsAndAnErrorTheInnermostBox) {
  FakeTask task;
  const auto left = task.robot("left", 2), right = task.robot("right", 3);
  const auto gate = task.sensor("gate");
  Drive outer({left.get()}), inner({right.get()});
  int steps = 0;
  outer.act = [&] {
    if (++steps == 3) Move({*right}, {*gate}, inner.until(ElapsedSteps{2}));
    if (steps == 5) throw NonFatalError("enough");
  };
  try {
    Move({*left}, {}, outer);
    FAIL();
  } catch (const NonFatalError& error) {
    std::vector<std::uint64_t> numbers;
    for (std::size_t i = 0; i < error.black_box()->size(); ++i) {
      const StepRecord& record = error.black_box()->at(i);
      numbers.push_back(record.instruction->number);
      const bool is_outer = record.instruction->robots.at(0) == "left";
      EXPECT_EQ(record.states.at(0).joints.size(), is_outer ? 2 : 3);
      EXPECT_EQ(record.readings.size(), is_outer ? 0U : 1U);
    }
    EXPECT_EQ(numbers, (std::vector<std::uint64_t>{1, 1, 2, 2, 2, 1, 1, 1}));
  }

  task.robot_fake("right").errors.clear();
  outer.act = [&] {
    Drive failing({right.get()});
    failing.act = [] { throw NonFatalError("inside"); };
    Move({*right}, {}, failing);
  };
  try {
    Move({*left}, {}, outer);
    FAIL();
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.black_box()->newest().instruction->robots.at(0), "right");
    EXPECT_EQ(task.black_box().newest().instruction->robots.at(0), "left");
  }
}

TEST(BlackBox, StopAndForeignExceptionAreRecorded) {
  FakeTask task;
  const auto arm = task.robot("arm");
  task.requests = {OperatorRequest::stop};
  EXPECT_THROW(Wait({*arm}, {}, ElapsedSteps{3}), Stopped);
  EXPECT_EQ(task.black_box().newest().ending, StepEnding::stopped);
  Drive drive({arm.get()});
  drive.act = [] { throw std::runtime_error("foreign"); };
  EXPECT_THROW(Move({*arm}, {}, drive), std::runtime_error);
  EXPECT_EQ(task.black_box().newest().ending, StepEnding::system_error);
}

}  // namespace
}  // namespace mrroc::black_box_test
