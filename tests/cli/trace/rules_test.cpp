// Each rule at a suitable place: exactly this rule is reported, with the expected value.
#include <gtest/gtest.h>

#include "cli/trace/trace_text.hpp"

namespace mrroc::cli::trace {
namespace {

/// Places in the example: the first line of an instruction.
std::size_t begin_of(const TraceText& trace, const std::string& process, std::uint64_t instruction) {
  for (std::size_t i = 0; i < trace.items.size(); ++i)
    if (trace.is_line(i) && trace.line(i).process == process && trace.line(i).instruction == instruction) return i;
  throw std::logic_error("no such instruction");
}

class TraceRule : public testing::Test {
 protected:
  Line& line(const std::string& process, std::uint64_t instruction, std::size_t step) {
    return trace.line(begin_of(trace, process, instruction) + step);
  }
  RobotEntry& arm(std::uint64_t instruction, std::size_t step) { return line("arm", instruction, step).robots.front(); }

  /// `rule` is found, and its text contains `text`.
  void expect(const std::string& rule, const std::string& text = "") const {
    const Found found = check_text(trace.text());
    EXPECT_TRUE(found.rules.contains(rule)) << found.text();
    EXPECT_NE(found.text().find(text), std::string::npos) << found.text();
  }
  void expect_only(const std::string& rule, const std::string& text = "") const {
    expect(rule, text);
    EXPECT_EQ(check_text(trace.text()).rules, std::set<std::string>{rule});
  }
  void expect_none() const { EXPECT_EQ(check_text(trace.text()).text(), ""); }

  void erase(std::size_t i) { trace.items.erase(trace.items.begin() + static_cast<std::ptrdiff_t>(i)); }

  TraceText trace = example_trace();
};

TEST_F(TraceRule, LineOrder) {
  const auto first = trace.items.begin() + static_cast<std::ptrdiff_t>(begin_of(trace, "mp", 1));
  std::rotate(trace.items.begin(), first, first + 1);
  expect_only("line-order", "a line not before tick ");
}

TEST_F(TraceRule, LineTick) {
  ++line("arm", 1, 1).tick;
  expect_only("line-tick", "the newest in the line");
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
  trace.items.insert(trace.items.begin() + static_cast<std::ptrdiff_t>(begin_of(trace, "arm", 8)) + 2, other);
  for (auto& item : trace.items)
    if (auto* remark = std::get_if<Remark>(&item); remark != nullptr && remark->process == "arm") ++remark->lines;
  expect_none();
}

TEST_F(TraceRule, EveryLine) {
  std::get<Remark>(trace.items.back()).lines += 2;
  expect_only("every-line", "11, as many as it has written");
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
  --std::get<Remark>(trace.items.back()).lines;
  expect_only("all-end", "without end=");
}

TEST_F(TraceRule, ProcessWithoutARemarkWasKilled) {
  trace.items.pop_back();
  erase(trace.items.size() - 1);
  const Found found = check_text(trace.text());
  EXPECT_TRUE(found.violations.empty()) << found.text();
  EXPECT_NE(found.text().find("note: the trace of process mp stops here: it was killed, in instruction 2"),
            std::string::npos)
      << found.text();
}

TEST_F(TraceRule, RemarkIsLast) {
  std::swap(trace.items[trace.items.size() - 2], trace.items.back());
  expect("remark-is-last");
}

TEST_F(TraceRule, EndOrCommand) {
  arm(1, 2).command.reset();
  expect_only("end-or-command", "no command to arm");
}

TEST_F(TraceRule, ConditionThatHoldsEndsAtThatStep) {
  line("arm", 2, 2).conditions[1].value = true;
  expect_only("condition-decides", "it continues, \"wrist above 10 N or travelled 0.1 m\"");
}

TEST_F(TraceRule, ConditionThatDoesNotHoldDoesNotEnd) {
  line("arm", 1, 3).conditions[0].value = false;
  expect_only("condition-decides", "end=condition, \"gate closer than 0.1 m\"");
}

TEST_F(TraceRule, EqualValuesDecideEqually) {
  for (std::size_t i = begin_of(trace, "mp", 2); trace.is_line(i); ++i) trace.line(i).name = "a name of its own";
  expect_none();
  line("mp", 2, 3).conditions[0].value = false;
  expect_only("condition-decides", "it continued with the same values before");
}

TEST_F(TraceRule, WaitHasNoGenerator) {
  line("arm", 1, 3).conditions[0].value = false;
  line("arm", 1, 3).ending = StepEnding::generator;
  expect_only("wait-has-no-generator");
}

TEST_F(TraceRule, MostSevereErrorDecides) {
  arm(7, 2).error = ErrorClass::hardware;
  expect_only("error-decides", "an error of arm");
}

TEST_F(TraceRule, Skew) {
  line("mp", 1, 4).skew = 2;
  expect_only("skew", "skew=2, expected 0");
}

TEST_F(TraceRule, WaitHolds) {
  arm(1, 1).command->kind = CommandKind::joint;
  arm(1, 1).command->target = arm(1, 2).desired;
  expect_only("wait-holds");
}

TEST_F(TraceRule, HoldStays) {
  line("mp", 2, 3).robots[1].desired[0] += 1e-15;
  expect_only("hold-stays", "of robot belt after a hold at rest");
}

TEST_F(TraceRule, JointTarget) {
  arm(2, 1).command->target[1] += 1e-15;
  expect_only("joint-target", ", as commanded");
}

TEST_F(TraceRule, RelativeJointTarget) {
  arm(7, 0).command->target[1] += 0.001;
  expect_only("joint-target");
}

TEST_F(TraceRule, PoseTarget) {
  arm(3, 0).command->target[2] += 1e-5;
  expect_only("pose-target", "the commanded pose");
}

TEST_F(TraceRule, PoseTargetIgnoresTheSignOfAQuaternion) {
  for (std::size_t i = 3; i < 7; ++i) arm(3, 0).command->target[i] *= -1;
  expect_none();
}

TEST_F(TraceRule, MacrostepStart) {
  RobotEntry& late = arm(2, 4);
  late.macrostep += 3;
  late.tick += 3;
  late.desired_tick += 3;
  line("arm", 2, 4).tick += 3;
  line("arm", 2, 4).sensors[0].tick += 3;
  expect("macrostep-start", "where the motion before ends");
}

TEST_F(TraceRule, ReplyTick) {
  arm(1, 2).command->reply_step = 7;
  expect_only("reply-tick", "tick 7 of the macrostep");
}

TEST_F(TraceRule, NAndVAreInRange) {
  arm(1, 2).command->reply_step = 12;
  expect("reply-tick", "an answer to N=10, v=12, expected an error");
}

TEST_F(TraceRule, MacrostepEnd) {
  arm(1, 3).desired_tick += 1;
  expect_only("macrostep-end", "N after the macrostep's start");
}

TEST_F(TraceRule, RestBeforeResume) {
  arm(3, 3).moving = true;
  expect_only("rest-before-resume", "rest before the motion continues after a pause");
}

TEST_F(TraceRule, RobotsRestAfterALateCommand) {
  for (std::size_t instruction = 2; instruction <= 5; ++instruction)
    for (std::size_t i = begin_of(trace, "arm", instruction); i < begin_of(trace, "arm", instruction + 1); ++i)
      if (instruction > 2 || trace.line(i).step >= 2) trace.line(i).robots[0].late = 1;
  for (std::size_t i = begin_of(trace, "arm", 7); trace.is_line(i); ++i) trace.line(i).robots[0].late = 1;
  expect_only("rest-before-resume", "after a late command");
}

TEST_F(TraceRule, HeldSteps) {
  line("arm", 3, 3).held = 20;
  expect_only("held-steps", "after 20 holds");
}

TEST_F(TraceRule, SensorPeriod) {
  line("arm", 2, 1).sensors[0].values[3] = 7;
  expect_only("sensor-period", "it has one every 2 steps");
}

TEST_F(TraceRule, SensorTick) {
  --line("arm", 2, 2).sensors[0].tick;
  --line("arm", 2, 3).sensors[0].tick;
  expect_only("sensor-tick", "this step's");
}

TEST_F(TraceRule, SensorTickWithoutRobots) {
  --line("arm", 6, 1).sensors[0].tick;
  --line("arm", 6, 1).tick;
  expect_only("sensor-tick");
}

TEST_F(TraceRule, SensorValues) {
  line("arm", 3, 2).sensors[0].values.pop_back();
  expect("sensor-values", "5 values of sensor wrist, expected 6");
}

TEST_F(TraceRule, CommonStart) {
  line("mp", 1, 1).robots[0].command->start_tick = 0;
  expect("common-start", "no start tick for arm");
}

TEST_F(TraceRule, NoSkew) {
  RobotEntry& belt = line("mp", 2, 2).robots[1];
  ++belt.macrostep;
  ++belt.tick;
  ++belt.desired_tick;
  ++line("mp", 2, 2).tick;
  expect("no-skew", "1 ticks apart");
}

TEST_F(TraceRule, OneCommander) {
  // the MP's first step while the arm's own task is between two commands
  Line intruder = line("mp", 1, 0);
  const std::size_t at = begin_of(trace, "arm", 5) + 1;
  intruder.tick = trace.line(at).tick;
  for (RobotEntry& robot : intruder.robots) robot.tick = robot.desired_tick = intruder.tick;
  intruder.process = "other";
  trace.items.insert(trace.items.begin() + static_cast<std::ptrdiff_t>(at) + 1, intruder);
  expect_only("one-commander", "robot arm is commanded by other too");
}

TEST_F(TraceRule, RemarkExplainsMissingStepsUnderTheRealClock) {
  trace.clock = "real";
  erase(begin_of(trace, "arm", 3) + 2);
  std::size_t remark = 0;
  while (trace.is_line(remark)) ++remark;
  --std::get<Remark>(trace.items[remark]).lines;
  expect("step-count");
  ++std::get<Remark>(trace.items[remark]).dropped;
  const Found found = check_text(trace.text());
  EXPECT_TRUE(found.violations.empty()) << found.text();
  EXPECT_NE(found.text().find("has dropped 1 lines"), std::string::npos) << found.text();
}

TEST_F(TraceRule, StateMayBeOfALaterTickUnderTheRealClock) {
  ++line("mp", 2, 3).robots[1].tick;
  ++line("mp", 2, 3).tick;
  expect_only("reply-tick");
  trace.clock = "real";
  expect_none();
}

TEST(TraceRules, HaveDistinctNamesAndAreListed) {
  std::set<std::string> names;
  for (const Rule& rule : all_rules()) {
    EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
    EXPECT_NE(text_of_rules().find(rule.says), std::string::npos);
    EXPECT_TRUE((rule.check != nullptr) != (rule.check_end != nullptr)) << rule.name;
  }
}

}  // namespace
}  // namespace mrroc::cli::trace
