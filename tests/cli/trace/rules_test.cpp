// Each rule at a suitable place: exactly this rule is reported, with the expected value.
#include "cli/trace/trace_rule.hpp"

namespace mrroc::cli::trace::rules_test {
namespace {

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

/// The operator has moved the robot meanwhile. A robot that was moving executes a late command.
TEST_F(TraceRule, LateCommandToARobotAtRestMayBeReplacedByAHold) {
  const auto target_is_missed = [this](bool moved, bool moves) {
    arm(2, 1).moving = moved;
    arm(2, 2).moving = moves;
    return check(trace).rules.contains("joint-target");
  };
  arm(2, 1).command->target[1] += 0.1;
  EXPECT_TRUE(target_is_missed(false, false)) << "it is not late";
  for (std::size_t i = begin_of(trace, "arm", 2) + 2; i < begin_of(trace, "arm", 3); ++i)
    trace.line(i).robots[0].late = 1;
  EXPECT_FALSE(target_is_missed(false, false));
  EXPECT_TRUE(target_is_missed(true, false));
  EXPECT_TRUE(target_is_missed(false, true));
  // one of several in a Move of its MP has braked in step with them, and holds
  arm(2, 1).superior = arm(2, 1).command;
  EXPECT_FALSE(target_is_missed(true, false));
  EXPECT_TRUE(target_is_missed(true, true));
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

TEST_F(TraceRule, RobotOfAnEcpMayHaveStoppedWithAnotherOfItsMp) {
  RobotEntry& slide = line("slide", 1, 2).robots[0];
  slide.moving = false;
  slide.desired[0] -= 0.005;
  EXPECT_TRUE(check(trace).rules.contains("joint-target"));
  slide.superior->kind = CommandKind::hold;
  EXPECT_FALSE(check(trace).rules.contains("joint-target")) << check(trace).text();
}

TEST_F(TraceRule, CommandThatAnEcpLeavesUnexecutedDelaysNoHold) {
  line("arm", 3, 3).held = 20;
  arm(3, 2).coordination = Coordination::takes_part;
  EXPECT_FALSE(check(trace).rules.contains("held-steps")) << check(trace).text();
  line("arm", 3, 3).held = 22;
  EXPECT_TRUE(check(trace).rules.contains("held-steps")) << check(trace).text();
}

/// Of the two robots of a Move the second one brakes with the first.
TEST_F(TraceRule, CommandIsExecutedInPartWhenAnotherRobotOfItsGroupStops) {
  Line& before = line("mp", 2, 2);
  Line& held = line("mp", 2, 3);
  ASSERT_EQ(held.robots.size(), 2U);
  const RobotEntry& second = before.robots[1];
  held.held = held.robots[1].macrostep - second.desired_tick + 1;
  ASSERT_GT(second.command->motion_steps, 1U);
  const std::string found = "of robot " + second.name + " after";
  EXPECT_NE(check(trace).text().find(found), std::string::npos) << "no robot has stopped";
  const RobotEntry first_before = before.robots[0], first = held.robots[0];
  const auto excused = [&] {
    const bool is = check(trace).text().find(found) == std::string::npos;
    before.robots[0] = first_before;
    held.robots[0] = first;
    return is;
  };
  before.robots[0].coordination = Coordination::takes_part;
  EXPECT_TRUE(excused()) << "its ECP has left";
  held.robots[0].late = first_before.late + 1;
  EXPECT_TRUE(excused()) << "its command was late";
  held.robots[0].error = ErrorClass::hardware;
  EXPECT_TRUE(excused()) << "it has a fault";
  held.held += 1;
  held.robots[0].late = first_before.late + 1;
  EXPECT_FALSE(excused()) << "a hold takes at least a tick";
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

TEST_F(TraceRule, SensorConfiguration) {
  line("arm", 2, 2).sensors[0].configured = 1;
  expect_only("sensor-configuration", "configuration=0 of sensor wrist, expected at least 1");
}

TEST_F(TraceRule, SensorConfigurationOfAnEarlierReading) {
  line("arm", 2, 1).sensors[0].configuration = 2;
  expect_only("sensor-configuration", "expected at least 2, that of the reading before");
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
  intruder.made = trace.line(at).made;
  for (RobotEntry& robot : intruder.robots) robot.tick = robot.desired_tick = intruder.tick;
  intruder.process = "other";
  trace.items.insert(trace.items.begin() + static_cast<std::ptrdiff_t>(at) + 1, intruder);
  expect_only("one-commander", "robot arm is commanded by other too");
}

TEST_F(TraceRule, EcpThatJoinsAfterTheQueryTakesPart) {
  trace.clock = "real";
  const auto line_of_station = [this](std::size_t from) {
    while (!trace.is_line(from) || trace.line(from).process != "station" || !trace.line(from).is_move) ++from;
    return from;
  };
  std::size_t first = line_of_station(0);
  while (trace.line(first).robots[0].coordination == Coordination::none) first = line_of_station(first + 1);
  const std::size_t second = line_of_station(first + 1);
  ASSERT_EQ(trace.line(first).step, 0U);
  std::swap(trace.items[second - 1], trace.items[second]);  // the MP's step first
  trace.line(first).robots[0].coordination = Coordination::none;
  expect_none();
  trace.line(second - 1).robots[0].coordination = Coordination::none;
  expect("one-commander", "robot slide is commanded by slide too");
}

TEST_F(TraceRule, EndExplainsMissingStepsUnderTheRealClock) {
  trace.clock = "real";
  erase(begin_of(trace, "arm", 3) + 2);
  std::size_t end = 0;
  while (trace.is_line(end)) ++end;
  --std::get<ProcessEnd>(trace.items[end]).lines;
  expect("step-count");
  ++std::get<ProcessEnd>(trace.items[end]).dropped;
  const Found found = check(trace);
  EXPECT_TRUE(found.violations.empty()) << found.text();
  EXPECT_NE(found.text().find("has dropped 1 steps"), std::string::npos) << found.text();
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
}  // namespace mrroc::cli::trace::rules_test
