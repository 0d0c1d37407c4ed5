#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "system/equal_runs.hpp"
#include "system/keyboard.hpp"
#include "system/trace_steps_of.hpp"
#include "text_of.hpp"

namespace mrroc::test {
namespace {

constexpr const char* kDemo = "sensors/operator_input/demo.toml";

/// The demo without its events, or with only the first `events` of them.
std::filesystem::path demo_with(const ScratchFolder& folder, std::size_t events) {
  const std::string text = text_of(std::string{MRROC_SOURCE_DIR} + "/" + kDemo);
  std::size_t end = text.find("[[events]]");
  for (std::size_t i = 0; i < events; ++i) end = text.find("[[events]]", end + 1);
  return folder.write("demo.toml", text.substr(0, end));
}

TEST(OperatorInputDemo, EventsAnswerAtTheirTicksOnEveryRun) {
  const ScratchFolder folder;
  const EqualRuns runs = expect_equal_runs(kDemo, folder);
  for (const std::string& output : runs.outputs)
    EXPECT_NE(output.find("2 parts of 3.75 kg together"), std::string::npos) << output;
  struct Answer {
    const char* sensor;
    Tick tick;
    double value;
  };
  for (const auto& [sensor, tick, value] :
       {Answer{"parts", 500, 2}, Answer{"weight", 800, 1.5}, Answer{"weight", 1000, 2.25}}) {
    const auto has_it = [&](const cli::trace::Line& step) {
      const cli::trace::SensorEntry* const entry = sensor_in(step, sensor);
      return entry != nullptr && entry->tick == tick && entry->values == cli::trace::Numbers{1, value};
    };
    EXPECT_FALSE(steps_where(runs.trace, has_it).empty()) << sensor << " at tick " << tick;
  }
}

class Typed : public testing::TestWithParam<const char*> {};

TEST_P(Typed, BadAnswersAreRefusedAndAskedForAgain) {
  const ScratchFolder folder;
  Keyboard keyboard;
  MrrocRun run({"run", demo_with(folder, 0).string(), "--clock", GetParam()});
  ASSERT_TRUE(run.wait_for_output("parts: How many parts are there? (a number from 1 to 10)"))
      << run.out() << run.err();
  keyboard.type("many\n");
  ASSERT_TRUE(run.wait_for_output("parts: 'many' is not a number, expected a number from 1 to 10")) << run.out();
  keyboard.type("11\n");
  ASSERT_TRUE(run.wait_for_output("parts: '11' is out of range, expected a number from 1 to 10")) << run.out();
  keyboard.type(" 2 \n");
  ASSERT_TRUE(run.wait_for_output("weight: What does the next part weigh, in kg? (a number from 0 to 50)"))
      << run.out();
  keyboard.type("1.5\n2.25\n");
  EXPECT_EQ(run.wait(), 0) << run.out() << run.err();
  EXPECT_NE(run.out().find("2 parts of 3.75 kg together"), std::string::npos) << run.out();
}

TEST_P(Typed, EndOfInputEndsTheRunWithTheQuestion) {
  const ScratchFolder folder;
  Keyboard keyboard;
  MrrocRun run({"run", demo_with(folder, 1).string(), "--clock", GetParam()});
  ASSERT_TRUE(run.wait_for_output("weight: What does")) << run.out() << run.err();
  keyboard.leave();
  EXPECT_EQ(run.wait(), 1) << run.out() << run.err();
  EXPECT_NE(run.err().find("weight: What does the next part weigh, in kg? No operator is left to answer"),
            std::string::npos)
      << run.err();
}

INSTANTIATE_TEST_SUITE_P(Clocks, Typed, testing::Values("paced", "real"),
                         [](const auto& test) { return std::string{test.param}; });

TEST(OperatorInputDemo, StartIsRefusedWithoutASourceOfAnswers) {
  const ScratchFolder folder;
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const StandardInput nobody(null);
  const std::string demo = demo_with(folder, 0).string();
  for (const std::string clock : {"lockstep", "paced", "real"}) {
    const std::string output = run_mrroc({"run", demo, "--clock", clock}, 2);
    EXPECT_NE(output.find("sensors.parts: asks the operator, and no answer can be typed"), std::string::npos) << output;
    EXPECT_EQ(output.find("starting"), std::string::npos) << output;
  }
  close(null);
}

TEST(OperatorInputDemo, QuestionAfterTheLastEventEndsTheRunInLockstep) {
  const ScratchFolder folder;
  Keyboard keyboard;  // typed answers would come at another tick in every run
  keyboard.type("1\n1\n");
  const std::string output = run_mrroc({"run", demo_with(folder, 2).string()}, 1);
  EXPECT_NE(output.find("weight: What does the next part weigh, in kg? No operator is left to answer"),
            std::string::npos)
      << output;
}

}  // namespace
}  // namespace mrroc::test
