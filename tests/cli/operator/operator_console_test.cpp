#include "cli/operator/operator_console.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>

#include "config/table.hpp"
#include "links/exchange/operator_requester.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::cli {
namespace {

config::SensorEntry asking(const std::string& name) {
  config::SensorEntry sensor;
  sensor.name = name;
  sensor.type = "operator_input";
  sensor.source = "hardware";
  sensor.numbers = {{"min", {0}}, {"max", {9}}};
  return sensor;
}

config::Deployment deployment_of(config::ClockMode clock) {
  config::Deployment deployment;
  deployment.name = "t";
  deployment.clock = clock;
  deployment.sensors = {asking("parts"), asking("weight")};
  return deployment;
}

links::OperatorQuestion number(const char* text, Tick tick) {
  links::OperatorQuestion question;
  question.text.assign(text);
  question.maximum = 9;
  question.tick = tick;
  return question;
}

/// The console and the VSPs of two sensors, in one process: a message arrives when it is sent.
class OperatorConsoleTest : public testing::Test {
 protected:
  OperatorConsoleTest() { EXPECT_EQ(pipe2(ends_.data(), O_CLOEXEC), 0); }
  ~OperatorConsoleTest() override {
    leave();
    close(ends_[0]);
  }
  void open(config::ClockMode clock = config::ClockMode::paced, std::vector<config::Event> events = {}) {
    deployment_ = deployment_of(clock);
    deployment_.events = std::move(events);
    input_.emplace(ends_[0]);
    console.emplace(deployment_, net_.domain, clock_, *input_,
                    [this](const std::string& line) { shown.push_back(line); });
    parts.emplace(net_.domain, clock_, "t/parts");
    weight.emplace(net_.domain, clock_, "t/weight");
    parts->connect(links::kPatience);
    weight->connect(links::kPatience);
  }
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
  links::TestDomain net_;
  links::TestClock clock_;
  config::Deployment deployment_;
  std::optional<ConsoleInput> input_;

  std::vector<std::string> shown;
  std::optional<OperatorConsole> console;
  std::optional<links::OperatorRequester> parts, weight;
};

using Lines = std::vector<std::string>;

TEST_F(OperatorConsoleTest, TypedLineAnswersTheQuestion) {
  open();
  console->poll();
  EXPECT_FALSE(console->waits_for_line());
  parts->ask(number("How many?", 5));
  console->poll();
  EXPECT_TRUE(console->waits_for_line());
  console->poll();
  EXPECT_EQ(shown, Lines{"parts: How many? (a number from 0 to 9)"});
  type("3\n");
  console->poll();
  EXPECT_FALSE(console->waits_for_line());
  expect_answer(*parts, 1, 3);
}

TEST_F(OperatorConsoleTest, BadAnswerIsRefusedAndTheQuestionStaysOpen) {
  open();
  parts->ask(number("How many?", 5));
  type("10\nx\n");
  console->poll();
  EXPECT_TRUE(console->waits_for_line());
  EXPECT_EQ(shown, (Lines{"parts: How many? (a number from 0 to 9)",
                          "parts: '10' is out of range, expected a number from 0 to 9",
                          "parts: 'x' is not a number, expected a number from 0 to 9"}));
  type("9\n");
  console->poll();
  expect_answer(*parts, 1, 9);
}

TEST_F(OperatorConsoleTest, QuestionsAreAskedOneAfterTheOther) {
  open();
  weight->ask(number("How heavy?", 5));
  console->poll();
  parts->ask(number("How many?", 6));
  console->poll();
  EXPECT_EQ(shown.size(), 1U);
  type("4\n7\n");
  console->poll();
  EXPECT_EQ(shown, (Lines{"weight: How heavy? (a number from 0 to 9)", "parts: How many? (a number from 0 to 9)"}));
  expect_answer(*weight, 1, 4);
  expect_answer(*parts, 1, 7);
}

TEST_F(OperatorConsoleTest, RepeatedQuestionReplacesTheEarlierOne) {
  open();
  parts->ask(number("How many?", 5));
  console->poll();
  weight->ask(number("How heavy?", 6));
  parts->ask(number("How many, really?", 7));
  console->poll();
  EXPECT_EQ(shown.back(), "weight: How heavy? (a number from 0 to 9)");
  type("1\n2\n");
  console->poll();
  expect_answer(*weight, 1, 1);
  expect_answer(*parts, 2, 2);
}

TEST_F(OperatorConsoleTest, EventAnswersAnyOpenQuestionAndIsWaitedFor) {
  const config::Event event{100, "answer", "parts", 6};
  open(config::ClockMode::lockstep, {event});
  parts->ask(number("How many?", 99));
  console->poll();
  EXPECT_FALSE(console->waits_for_line());
  EXPECT_EQ(shown, Lines{"parts: How many? (answered at tick 100)"});
  console->answer(event);
  expect_answer(*parts, 0, 6);
}

TEST_F(OperatorConsoleTest, EventOfTheSameTickOrOfAnotherSensorAnswersNothing) {
  open(config::ClockMode::lockstep, {{100, "answer", "parts", 6}, {200, "answer", "weight", 6}});
  type("3\n");  // what is typed would come at another tick on every run
  parts->ask(number("How many?", 100));
  EXPECT_THROW(console->poll(), NonFatalError);
}

TEST_F(OperatorConsoleTest, QuestionOpenAtTheEndOfInputIsAnError) {
  open();
  parts->ask(number("How many?", 5));
  console->poll();
  leave();
  try {
    console->poll();
    FAIL() << "the question cannot be answered";
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::sensor_not_ready);
    EXPECT_NE(std::string{error.what()}.find("parts: How many? No operator is left to answer"), std::string::npos);
  }
}

TEST_F(OperatorConsoleTest, EmergencyStopWaitsForNoQuestionAndAnswersNone) {
  open();
  const clock::EmergencyStop& stop = clock_.emergency_stop();
  console->poll();
  EXPECT_EQ(stop.presses(), 0U);
  type("4\nestop\n");  // the first line is for a question to come
  console->poll();
  EXPECT_EQ(stop.presses(), 1U);
  EXPECT_EQ(stop.resets(), 0U);
  EXPECT_EQ(shown, Lines{"emergency stop: every robot stops until the line 'reset'"});
  parts->ask(number("How many?", 5));
  type(" reset \r\nestop\n");
  console->poll();
  EXPECT_EQ(stop.presses(), 2U);
  EXPECT_EQ(stop.resets(), 1U);
  expect_answer(*parts, 1, 4);
  console->emergency("reset");
  EXPECT_EQ(stop.resets(), 2U);
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
    config::Deployment deployment = deployment_of(clock);
    EXPECT_EQ(refusal(deployment, true).empty(), clock != config::ClockMode::lockstep);
    deployment.events = {{100, "answer", "parts", 6}};
    EXPECT_NE(refusal(deployment, false).find("sensors.weight: asks the operator, and no answer can be typed"),
              std::string::npos);
    deployment.events.push_back({100, "answer", "weight", 6});
    EXPECT_EQ(refusal(deployment, false), "");
  }
}

TEST(SomebodyAnswers, ReplayedSensorsNeedNoOperator) {
  config::Deployment deployment = deployment_of(config::ClockMode::lockstep);
  for (config::SensorEntry& sensor : deployment.sensors) sensor.source = "replay";
  EXPECT_EQ(refusal(deployment, false), "");
}

TEST_F(OperatorConsoleTest, ProgramAsksLikeASensor) {
  open();
  links::OperatorRequester mp(net_.domain, clock_, "t/mp");
  mp.connect(links::kPatience);
  links::OperatorQuestion question = number("Three parts are done.", 3);
  question.kind = links::QuestionKind::none;
  mp.ask(question);
  question = number("Continue?", 4);
  question.kind = links::QuestionKind::yes_no;
  mp.ask(question);
  console->poll();
  EXPECT_EQ(shown, (Lines{"mp: Three parts are done.", "mp: Continue? (yes or no)"}));
  type("no\n");
  console->poll();
  expect_answer(mp, 2, 0);
}

}  // namespace
}  // namespace mrroc::cli
