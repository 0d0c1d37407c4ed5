// Content and order of the calls of an observer of the steps of Move and Wait.
#include <gtest/gtest.h>

#include "language/drive.hpp"
#include "mrroc/conditions/elapsed_steps.hpp"
#include "mrroc/move.hpp"

namespace mrroc::observer_test {
namespace {

using fakes::Action;
using fakes::Call;
using fakes::Drive;
using fakes::FakeTask;

/// Records its calls.
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
    const InstructionRecord& instruction = *record.instruction;
    seen.push_back({instruction.is_move,
                    record.last(),
                    instruction.number,
                    record.step,
                    instruction.name,
                    record.tick,
                    record.states.size(),
                    record.readings.size(),
                    {},
                    {}});
    for (std::size_t i = 0; i < record.conditions.size(); ++i) {
      seen.back().conditions.push_back(instruction.conditions[i]);
      seen.back().values.push_back(record.conditions[i] != 0);
    }
  }
  std::vector<Seen> seen;
};

TEST(Observer, ReceivesEveryStepAndInstructionsAreCounted) {
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

// parts of a task that begin together: the one with the first reply is reported first
TEST(Observer, ParallelInstructionsAreCountedInTheOrderOfTheirReports) {
  FakeTask task;
  Recorder recorder;
  task.step_observer = &recorder;
  const auto left = task.robot("left");
  const auto right = task.robot("right");
  Drive slow({left.get()}), quick({right.get()});
  slow.act = [&] {
    if (recorder.seen.empty()) Move({*right}, {}, quick.until(ElapsedSteps{1}));
  };
  Move({*left}, {}, slow.until(ElapsedSteps{1}));
  std::vector<std::uint64_t> numbers;
  for (const Recorder::Seen& seen : recorder.seen) numbers.push_back(seen.instruction);
  EXPECT_EQ(numbers, (std::vector<std::uint64_t>{1, 1, 2, 2}));
}

TEST(Observer, EndMotionShowsNoUnevaluatedValues) {
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

TEST(Observer, IsCalledBetweenTheTwoEndsOfTheExchange) {
  FakeTask task;
  class Marker : public StepObserver {
   public:
    explicit Marker(fakes::CallLog& log) : log_(log) {}
    void on_step(const StepRecord&) noexcept override { log_.add({.action = Action::observe, .device = ""}); }

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

}  // namespace
}  // namespace mrroc::observer_test
