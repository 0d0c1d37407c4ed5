// Each rule of the lines as such at a suitable place: exactly this rule is reported, with the expected value.
#include "cli/trace/trace_rule.hpp"

namespace mrroc::cli::trace::rules_of_lines_test {
namespace {

TEST_F(TraceRule, LineOrder) {
  const auto first = trace.items.begin() + static_cast<std::ptrdiff_t>(begin_of(trace, "mp", 1));
  std::rotate(trace.items.begin(), first, first + 1);
  expect_only("step-order", "a step not before tick ");
}

TEST_F(TraceRule, LineTick) {
  ++line("arm", 1, 1).tick;
  expect_only("step-tick", "the newest in the step");
}

TEST_F(TraceRule, TicksContinueFromOneInstructionToTheNext) {
  arm(2, 0).macrostep = 1;
  expect_only("ticks-go-on", "macrostep 1 of robot arm, expected at least ");
}

TEST_F(TraceRule, ReadingsContinue) {
  line("arm", 8, 1).sensors[0].tick = line("arm", 8, 0).sensors[0].tick - 1;
  expect_only("readings-go-on", "of sensor eye, expected at least ");
}

TEST_F(TraceRule, OneOfTwoSimultaneousInstructionsMayHoldAnOlderReading) {
  Line other = line("arm", 6, 2);
  other.instruction = 9;
  other.step = 0;
  other.sensors = line("arm", 8, 2).sensors;
  other.tick = ++other.sensors[0].tick;
  other.made = line("arm", 8, 1).made;
  trace.items.insert(trace.items.begin() + static_cast<std::ptrdiff_t>(begin_of(trace, "arm", 8)) + 2, other);
  for (auto& item : trace.items)
    if (auto* end = std::get_if<ProcessEnd>(&item); end != nullptr && end->process == "arm") ++end->lines;
  expect_none();
}

TEST_F(TraceRule, EveryLine) {
  std::get<ProcessEnd>(trace.items.back()).lines += 2;
  expect_only("every-step", "11, as many as it has passed on");
}

TEST_F(TraceRule, InstructionCount) {
  const std::size_t first = begin_of(trace, "mp", 2);
  for (std::size_t i = first; trace.is_line(i); ++i) trace.line(i).instruction = 4;
  expect_only("instruction-count", "instruction 4, expected instruction 2");
}

TEST_F(TraceRule, StepCount) {
  for (std::size_t step = 2; step <= 4; ++step) ++line("arm", 2, step).step;
  expect("step-count", "step 3, expected step 2");
}

TEST_F(TraceRule, RepeatedStepIsOneWhoseExchangeWasInterrupted) {
  line("arm", 8, 3).ending = StepEnding::generator;
  expect("step-count", "step 2, expected step 3");
}

TEST_F(TraceRule, OneForm) {
  line("arm", 3, 2).name = "ToolVelocities";
  expect_only("one-form", "ToolVelocities");
}

TEST_F(TraceRule, Lists) {
  line("arm", 1, 1).sensors.push_back(line("arm", 1, 1).sensors.front());
  expect("lists", "sensor gate twice");
}

TEST_F(TraceRule, InstructionEndsBeforeTheNextOneWithItsRobotBegins) {
  erase(begin_of(trace, "arm", 2) - 1);
  expect("lists", "the end of instruction 1 before");
}

TEST_F(TraceRule, InstructionsWithOtherRobotsMayRunAtTheSameTime) {
  const std::size_t end = begin_of(trace, "arm", 6) - 1;
  std::swap(trace.items[end], trace.items[end + 1]);
  trace.line(end + 1).tick = trace.line(end).tick;
  expect_none();
}

TEST_F(TraceRule, NothingAfterEnd) {
  const std::size_t end = begin_of(trace, "arm", 2) - 1;
  trace.items.insert(trace.items.begin() + static_cast<std::ptrdiff_t>(end), trace.items[end]);
  expect("nothing-after-end");
}

TEST_F(TraceRule, AllEnd) {
  const std::size_t last = trace.items.size() - 2;
  erase(last);
  --std::get<ProcessEnd>(trace.items.back()).lines;
  expect_only("all-end", "without an end");
}

TEST_F(TraceRule, ProcessWithoutAnEndWasKilled) {
  trace.items.pop_back();
  erase(trace.items.size() - 1);
  const Found found = check(trace);
  EXPECT_TRUE(found.violations.empty()) << found.text();
  EXPECT_NE(found.text().find("note: the steps of process mp stop here: it was killed, in instruction 2"),
            std::string::npos)
      << found.text();
}

TEST_F(TraceRule, EndIsLast) {
  std::swap(trace.items[trace.items.size() - 2], trace.items.back());
  expect("end-is-last");
}

}  // namespace
}  // namespace mrroc::cli::trace::rules_of_lines_test
