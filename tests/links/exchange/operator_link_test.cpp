#include <gtest/gtest.h>

#include "links/exchange/operator_requester.hpp"
#include "links/exchange/operator_responder.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

OperatorQuestion question(const char* text, Tick tick) {
  OperatorQuestion asked;
  asked.text.assign(text);
  asked.tick = tick;
  return asked;
}

TEST(OperatorLink, CarriesQuestionsAndAnswersInOrder) {
  TestDomain net;
  TestClock clock;
  OperatorRequester vsp(net.domain, clock, "t/parts");
  OperatorResponder console(net.domain, clock, "t/parts");
  vsp.connect(kPatience);
  EXPECT_EQ(vsp.ask(question("how many parts?", 100)), 1U);
  EXPECT_EQ(vsp.ask(question("sure?", 120)), 2U);
  OperatorQuestion taken;
  std::uint64_t number = 0;
  ASSERT_TRUE(console.take(taken, number));
  EXPECT_EQ(taken.text.view(), "how many parts?");
  EXPECT_EQ(taken.tick, 100U);
  EXPECT_EQ(number, 1U);
  ASSERT_TRUE(console.take(taken, number));
  EXPECT_EQ(taken.text.view(), "sure?");
  EXPECT_EQ(number, 2U);
  EXPECT_FALSE(console.take(taken, number));

  OperatorAnswer answer;
  EXPECT_FALSE(vsp.take(answer));
  console.answer({1, 3});
  console.answer({2, 1});
  ASSERT_TRUE(vsp.take(answer));
  EXPECT_EQ(answer.question, 1U);
  EXPECT_EQ(answer.value, 3);
  ASSERT_TRUE(vsp.take(answer));
  EXPECT_EQ(answer.question, 2U);
  EXPECT_FALSE(vsp.take(answer));
}

TEST(OperatorLink, VspReportsAMissingOperator) {
  TestDomain net;
  TestClock clock;
  OperatorRequester vsp(net.domain, clock, "t/parts");
  try {
    vsp.connect(0.2);
    FAIL() << "without a connection";
  } catch (const SystemError& error) {
    EXPECT_EQ(error.code(), ErrorCode::link_lost);
    EXPECT_NE(std::string{error.what()}.find("the operator"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace mrroc::links
