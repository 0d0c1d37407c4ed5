#include "mrroc/sensors/operator_input.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "mrroc/errors.hpp"
#include "mrroc/move.hpp"
#include "sensors/operator_input/made_sensor.hpp"
#include "sensors/played_task.hpp"

namespace mrroc {
namespace {

/// A replayed task whose operator ends every instruction after a given tick, like a superior's end-motion.
class EndedTask : public vsp::PlayedTask {
 public:
  using PlayedTask::PlayedTask;
  OperatorRequest operator_request() noexcept override {
    return tick() >= end ? OperatorRequest::end_motion : OperatorRequest::none;
  }
  Tick end = kNever;
};

/// An `OperatorInput` with replayed answers: lines of tick, number of answers so far, and the last of them. A step
/// without robots is 10 ticks.
class OperatorInputTest : public ::testing::Test {
 protected:
  void play(const std::string& lines, Tick period = 0) {
    task_ =
        std::make_unique<EndedTask>(aggregating_, "operator_input", "# mrroc readings answers value\n" + lines, period);
    input_ = std::make_unique<OperatorInput>(*task_, "parts");
  }
  OperatorInput& input() { return *input_; }
  EndedTask& task() { return *task_; }

 private:
  vsp::OperatorInputSensor aggregating_ = vsp::made_sensor();
  std::unique_ptr<EndedTask> task_;
  std::unique_ptr<OperatorInput> input_;
};

TEST_F(OperatorInputTest, IsNotAnsweredBeforeTheFirstReading) {
  play("0 0 0\n");
  EXPECT_FALSE(input().answered());
  EXPECT_TRUE(std::isnan(input().answer()));
}

TEST_F(OperatorInputTest, AskWaitsForTheAnswerAndReturnsIt) {
  play("0 0 0\n 37 1 3\n");
  EXPECT_EQ(ask(input()), 3);
  EXPECT_EQ(task().tick(), 40U);
  EXPECT_TRUE(input().answered());
}

TEST_F(OperatorInputTest, EarlierAnswerDoesNotAnswerTheNextQuestion) {
  play("0 0 0\n 7 1 3\n 33 2 -4.5\n");
  EXPECT_EQ(ask(input()), 3);
  EXPECT_EQ(ask(input()), -4.5);
  EXPECT_EQ(task().tick(), 40U);
}

TEST_F(OperatorInputTest, AnswerFromBeforeTheQuestionIsIgnored) {
  play("0 5 1\n 20 6 2\n");
  EXPECT_EQ(ask(input()), 2);
}

TEST_F(OperatorInputTest, QuestionMayBeOpenDuringAWaitForAnotherCondition) {
  play("0 0 0\n 25 1 8\n");
  input().ask();
  EXPECT_FALSE(input().answered());
  const Outcome outcome = Wait({}, {input()}, Answered{input()} || When{"never", [] { return false; }});
  EXPECT_TRUE(outcome.by("parts answered"));
  EXPECT_EQ(input().answer(), 8);
}

TEST_F(OperatorInputTest, WaitEndedFromOutsideIsNoAnswer) {
  play("0 0 0\n");
  task().end = 30;
  try {
    ask(input());
    FAIL() << "there is no answer";
  } catch (const NonFatalError& error) {
    EXPECT_EQ(error.code(), ErrorCode::sensor_not_ready);
    EXPECT_NE(std::string{error.what()}.find("parts"), std::string::npos) << error.what();
  }
}

TEST_F(OperatorInputTest, NonInteractiveSensorCannotAsk) {
  play("0 0 0\n", 5);
  EXPECT_THROW(input().ask(), NonFatalError);
}

}  // namespace
}  // namespace mrroc
