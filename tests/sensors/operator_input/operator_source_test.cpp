#include "sensors/operator_input/operator_source.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "links/exchange/operator_responder.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "sensors/entry.hpp"
#include "sensors/operator_input/operator_input_sensor.hpp"

namespace mrroc::vsp {
namespace {

/// The source in a VSP and the operator's end of its link, in one process: a message has arrived when it is sent.
class OperatorSourceTest : public ::testing::Test {
 protected:
  RawReading read() {
    RawReading r;
    EXPECT_EQ(source.read(++tick, r), SourceState::ready);
    EXPECT_EQ(r.count, 2U);
    EXPECT_EQ(r.tick, tick);
    return r;
  }
  void expect_answers(double count, double value) {
    const RawReading r = read();
    EXPECT_EQ(r.values[0], count);
    EXPECT_EQ(r.values[1], value);
  }

  links::TestDomain net;
  links::TestClock clock;
  config::SensorEntry entry = entry_of("operator_input", "parts", "question = \"how many?\"\nmin = 0\nmax = 9\n");
  links::OperatorResponder console{net.domain, clock, "t/parts"};
  OperatorSource source{entry, net.domain, clock, "t/parts", links::kPatience};
  Tick tick = 100;
};

TEST_F(OperatorSourceTest, AsksTheQuestionOfTheDeployment) {
  source.ask(140);
  links::OperatorQuestion question;
  std::uint64_t number = 0;
  ASSERT_TRUE(console.take(question, number));
  EXPECT_EQ(question.text.view(), "how many?");
  EXPECT_EQ(question.tick, 140U);
  EXPECT_EQ(number, 1U);
}

TEST_F(OperatorSourceTest, CountsTheAnswerToTheOpenQuestion) {
  expect_answers(0, 0);
  source.ask(101);
  expect_answers(0, 0);
  console.answer({1, 4});
  expect_answers(1, 4);
  expect_answers(1, 4);
}

TEST_F(OperatorSourceTest, EventAnswersAnyOpenQuestion) {
  source.ask(101);
  source.ask(102);
  console.answer({0, 7});
  expect_answers(1, 7);
}

TEST_F(OperatorSourceTest, IgnoresAnswersWithoutAnOpenQuestion) {
  console.answer({0, 1});  // there is no question yet
  expect_answers(0, 0);
  source.ask(101);
  source.ask(102);
  console.answer({1, 2});  // that question was withdrawn
  expect_answers(0, 0);
  console.answer({2, 3});
  console.answer({2, 4});  // already answered
  expect_answers(1, 3);
}

TEST_F(OperatorSourceTest, IgnoresAnswersThatTheSensorRefuses) {
  source.ask(101);
  for (const double value : {-1.0, 9.5, std::numeric_limits<double>::quiet_NaN()}) console.answer({0, value});
  expect_answers(0, 0);
  console.answer({0, 9});
  expect_answers(1, 9);
}

TEST_F(OperatorSourceTest, SensorOpensItAndABiasAsks) {
  OperatorInputSensor sensor;
  config::Deployment deployment;
  deployment.name = std::string{"t"};
  config::SensorEntry other = entry;
  other.name = "others";
  other.source = "hardware";
  links::OperatorResponder operators(net.domain, clock, "t/others");
  const auto own = sensor.open_source({deployment, other, 0, nullptr, 0.002, &clock, &net.domain});
  ASSERT_TRUE(own);
  RawReading r;
  own->read(200, r);
  EXPECT_TRUE(sensor.bias(r));
  links::OperatorQuestion question;
  std::uint64_t number = 0;
  ASSERT_TRUE(operators.take(question, number));
  EXPECT_EQ(question.tick, 200U);
  other.source = "replay";
  EXPECT_FALSE(sensor.open_source({deployment, other, 0, nullptr, 0.002}));
}

}  // namespace
}  // namespace mrroc::vsp
