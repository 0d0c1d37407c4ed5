#include "cli/operator/terminal/operator_console.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <memory>

#include "cli/operator/operator_rig.hpp"
#include "config/table.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::cli::operator_console_test {
namespace {

/// The console and the VSPs of two sensors, in one process.
class OperatorConsoleTest : public testing::Test {
 protected:
  OperatorConsoleTest() { EXPECT_EQ(pipe2(ends_.data(), O_CLOEXEC), 0); }
  ~OperatorConsoleTest() override {
    leave();
    close(ends_[0]);
  }
  void open(config::ClockMode clock = config::ClockMode::paced, std::vector<config::Event> events = {}) {
    config::Deployment deployment = asking_deployment(clock);
    deployment.events = std::move(events);
    rig = std::make_unique<OperatorRig>(deployment);
    input_.emplace(ends_[0]);
    console.emplace(rig->service, rig->questions, *input_,
                    [this](const std::string& line) { rig->shown.push_back(line); });
    parts.emplace(rig->net.domain, rig->clock, "t/parts");
    weight.emplace(rig->net.domain, rig->clock, "t/weight");
    parts->connect(links::kPatience);
    weight->connect(links::kPatience);
    rig->next_tick();
  }
  /// What the runner does in a turn, and the next tick.
  void poll(bool others_answer = false) {
    console->poll(others_answer);
    rig->next_tick();
  }
  const std::vector<std::string>& shown() const { return rig->shown; }
  void type(const std::string& text) { ASSERT_EQ(write(ends_[1], text.data(), text.size()), std::ssize(text)); }
  void leave() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }
  static void expect_answer(links::OperatorRequester& vsp, std::uint64_t question, double value) {
    links::OperatorAnswer answer;
    ASSERT_TRUE(vsp.take(answer));
    EXPECT_EQ(answer.question, question);
    EXPECT_EQ(answer.value, value);
    EXPECT_FALSE(vsp.take(answer));
  }

  std::array<int, 2> ends_{-1, -1};
  std::unique_ptr<OperatorRig> rig;
  std::optional<ConsoleInput> input_;
  std::optional<OperatorConsole> console;
  std::optional<links::OperatorRequester> parts, weight;
};

using Lines = std::vector<std::string>;

TEST_F(OperatorConsoleTest, TypedLineAnswersTheQuestion) {
  open();
  poll();
  EXPECT_FALSE(console->waits_for_line());
  parts->ask(number_question("How many?", 5));
  poll();
  EXPECT_TRUE(console->waits_for_line());
  poll();
  EXPECT_EQ(shown(), Lines{"parts: How many? (a number from 0 to 9)"});
  type("3\n");
  poll();
  EXPECT_FALSE(console->waits_for_line());
  expect_answer(*parts, 1, 3);
}

TEST_F(OperatorConsoleTest, BadAnswerIsRefusedAndTheQuestionStaysOpen) {
  open();
  parts->ask(number_question("How many?", 5));
  type("10\nx\n");
  poll();
  EXPECT_TRUE(console->waits_for_line());
  EXPECT_EQ(shown(), (Lines{"parts: How many? (a number from 0 to 9)",
                            "parts: '10' is out of range, expected a number from 0 to 9",
                            "parts: 'x' is not a number, expected a number from 0 to 9"}));
  type("9\n");
  poll();
  expect_answer(*parts, 1, 9);
}

TEST_F(OperatorConsoleTest, QuestionsAreAskedOneAfterTheOther) {
  open();
  weight->ask(number_question("How heavy?", 5));
  poll();
  parts->ask(number_question("How many?", 6));
  poll();
  EXPECT_EQ(shown().size(), 1U);
  type("4\n7\n");
  poll();
  EXPECT_EQ(shown(), (Lines{"weight: How heavy? (a number from 0 to 9)", "parts: How many? (a number from 0 to 9)"}));
  expect_answer(*weight, 1, 4);
  expect_answer(*parts, 1, 7);
}

TEST_F(OperatorConsoleTest, RepeatedQuestionReplacesTheEarlierOne) {
  open();
  parts->ask(number_question("How many?", 5));
  poll();
  weight->ask(number_question("How heavy?", 6));
  parts->ask(number_question("How many, really?", 7));
  poll();
  EXPECT_EQ(shown().back(), "weight: How heavy? (a number from 0 to 9)");
  type("1\n2\n");
  poll();
  expect_answer(*weight, 1, 1);
  expect_answer(*parts, 2, 2);
}

TEST_F(OperatorConsoleTest, EventAnswersAnyOpenQuestionAndIsWaitedFor) {
  const config::Event event{.tick = 100, .command = "answer", .asker = "parts", .value = 6};
  open(config::ClockMode::lockstep, {event});
  parts->ask(number_question("How many?", 99));
  poll();
  EXPECT_FALSE(console->waits_for_line());
  EXPECT_EQ(shown(), Lines{"parts: How many? (answered at tick 100)"});
  while (rig->tick < 100) rig->next_tick();
  expect_answer(*parts, 0, 6);
}

TEST_F(OperatorConsoleTest, EventOfTheSameTickOrOfAnotherSensorAnswersNothing) {
  open(config::ClockMode::lockstep, {{.tick = 100, .command = "answer", .asker = "parts", .value = 6},
                                     {.tick = 200, .command = "answer", .asker = "weight", .value = 6}});
  type("3\n");  // what is typed would come at another tick on every run
  parts->ask(number_question("How many?", 100));
  EXPECT_THROW(poll(), NonFatalError);
}

TEST_F(OperatorConsoleTest, QuestionOpenAtTheEndOfInputIsAnError) {
  open();
  parts->ask(number_question("How many?", 5));
  poll();
  leave();
  try {
    poll();
    FAIL() << "the question cannot be answered";
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::sensor_not_ready);
    EXPECT_NE(std::string{error.what()}.find("parts: How many? No operator is left to answer"), std::string::npos);
  }
}

TEST_F(OperatorConsoleTest, EmergencyStopWaitsForNoQuestionAndAnswersNone) {
  open();
  const clock::EmergencyStop& stop = rig->clock.emergency_stop();
  poll();
  EXPECT_EQ(stop.presses(), 0U);
  type("4\nestop\n");  // the first line is for a question to come
  poll();
  EXPECT_EQ(stop.presses(), 1U);
  EXPECT_EQ(stop.resets(), 0U);
  EXPECT_EQ(shown(), Lines{"estop: every robot brakes and stays stopped until 'reset' [tick 2]"});
  parts->ask(number_question("How many?", 5));
  type(" Reset \r\nESTOP\n");
  poll();
  EXPECT_EQ(stop.presses(), 2U);
  EXPECT_EQ(stop.resets(), 1U);
  expect_answer(*parts, 1, 4);
}

TEST_F(OperatorConsoleTest, VerbIsExecutedAtOnceAndOtherLinesWaitForAQuestion) {
  open();
  rig->received();
  type("7\npause\n");
  poll();
  EXPECT_EQ(rig->received(), std::vector{links::TaskCommandKind::pause});
  EXPECT_EQ(shown(), Lines{"pause: the robots come to rest and hold [tick 1]"});
  type("resume\ntrigger now\n");
  poll();
  EXPECT_EQ(rig->received(), std::vector{links::TaskCommandKind::resume});
  EXPECT_EQ(shown()[1], "trigger: 'now' is too much, expected trigger");
  parts->ask(number_question("How many?", 5));
  poll();
  expect_answer(*parts, 1, 7);
}

TEST_F(OperatorConsoleTest, AnswerComesBeforeAVerbAndEmergencyStopBeforeAnAnswer) {
  open();
  rig->received();
  links::OperatorQuestion question = number_question("What next?", 5);
  question.kind = links::QuestionKind::choice;
  question.choice_count = 2;
  question.choices[0].assign("pause");
  question.choices[1].assign("estop");
  parts->ask(question);
  type("estop\npause\npause\n");
  poll();
  EXPECT_EQ(rig->clock.emergency_stop().presses(), 1U);
  expect_answer(*parts, 1, 0);
  poll();
  EXPECT_EQ(rig->received(), std::vector{links::TaskCommandKind::pause}) << "no question is open any more";
}

TEST_F(OperatorConsoleTest, OpenQuestionWaitsWhileAnotherClientMayAnswer) {
  open();
  leave();
  parts->ask(number_question("How many?", 5));
  poll(true);
  EXPECT_TRUE(console->waits_for_line());
  EXPECT_THROW(poll(false), NonFatalError);
}

TEST_F(OperatorConsoleTest, HelpListsEveryVerb) {
  open();
  type("help\n");
  poll();
  ASSERT_EQ(shown().size(), 1U);
  for (const OperatorVerb& verb : operator_verbs())
    EXPECT_NE(shown()[0].find(usage_of(verb)), std::string::npos) << verb.name;
}

std::string refusal(const config::Deployment& deployment, bool attended) {
  try {
    check_somebody_answers(deployment, attended);
    return "";
  } catch (const config::ConfigurationError& error) {
    return error.what();
  }
}

TEST(SomebodyAnswers, TerminalOrEventForEverySensorIsAccepted) {
  for (const auto clock : {config::ClockMode::lockstep, config::ClockMode::paced, config::ClockMode::real}) {
    config::Deployment deployment = asking_deployment(clock);
    EXPECT_EQ(refusal(deployment, true).empty(), clock != config::ClockMode::lockstep);
    deployment.events = {{.tick = 100, .command = "answer", .asker = "parts", .value = 6}};
    EXPECT_NE(refusal(deployment, false).find("sensors.weight: asks the operator, and no answer can be typed"),
              std::string::npos);
    deployment.events.push_back({.tick = 100, .command = "answer", .asker = "weight", .value = 6});
    EXPECT_EQ(refusal(deployment, false), "");
  }
}

TEST(SomebodyAnswers, ReplayedSensorsNeedNoOperator) {
  config::Deployment deployment = asking_deployment(config::ClockMode::lockstep);
  for (config::SensorEntry& sensor : deployment.sensors) sensor.source = "replay";
  EXPECT_EQ(refusal(deployment, false), "");
}

TEST_F(OperatorConsoleTest, ProgramAsksLikeASensor) {
  open();
  links::OperatorRequester mp(rig->net.domain, rig->clock, "t/mp");
  mp.connect(links::kPatience);
  links::OperatorQuestion question = number_question("Three parts are done.", 3);
  question.kind = links::QuestionKind::none;
  mp.ask(question);
  question = number_question("Continue?", 4);
  question.kind = links::QuestionKind::yes_no;
  mp.ask(question);
  poll();
  EXPECT_EQ(shown(), (Lines{"mp: Three parts are done.", "mp: Continue? (yes or no)"}));
  type("no\n");
  poll();
  expect_answer(mp, 2, 0);
}

}  // namespace
}  // namespace mrroc::cli::operator_console_test
