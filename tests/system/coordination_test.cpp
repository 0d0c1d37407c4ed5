// Coordination of the programs of ECPs by an MP, and of several parts of its own task, with `mrroc run`.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <tuple>

#include "system/keyboard.hpp"
#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::coordination_test {
namespace {

const std::string kBelt =
    "type = \"conveyor\"\nhardware = \"loopback\"\nprogram = \"" MRROC_BINARY_DIR "/tests/coordination_ecp\"\n";

std::filesystem::path deployment(const ScratchFolder& folder, const std::string& scenario,
                                 const std::string& more = "") {
  return folder.write("coordination.toml", "[deployment]\nname = \"coordination\"\n[mp]\nprogram = \"" MRROC_BINARY_DIR
                                           "/tests/coordination_mp\"\n[robots.left]\n" +
                                               kBelt + "[robots.right]\n" + kBelt +
                                               "[[answers]]\nquestion = \"Which?\"\nanswer = \"" + scenario + "\"\n" +
                                               more);
}

constexpr int kPatience = 60;  // s
constexpr int kStopped = 5;

/// Runs the scenario twice in lockstep and once in real time; the lines must appear in this order. Returns the output
/// of the first run.
std::string expect_lines(const std::filesystem::path& file, const std::vector<std::string>& lines, int code = 0) {
  const ScratchFolder folder;
  std::string first;
  const std::vector<std::string> clocks{"lockstep", "lockstep", "real"};
  for (std::size_t run = 0; run < clocks.size(); ++run) {
    const auto trace = folder.path() / (std::to_string(run) + ".mcap");
    const std::string output = run_mrroc(
        {"run", file.string(), "--quiet", "--clock", clocks[run], "--record", trace.string()}, code, kPatience);
    std::size_t from = 0;
    for (const std::string& line : lines) {
      const std::size_t at = output.find(line, from);
      EXPECT_NE(at, std::string::npos) << "'" << line << "' is missing (" << clocks[run] << ") in\n" << output;
      if (at != std::string::npos) from = at + line.size();
    }
    if (run == 0) first = output;
  }
  EXPECT_EQ(trace_hash(folder.path() / "0.mcap"), trace_hash(folder.path() / "1.mcap"));
  return first;
}

TEST(Coordination, BehavioursAreStartedWithTheirMessagesAndAwaited) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "behaviours"),
               {"refused: non-fatal error: the receiver is busy: start: the ECP of robot 'left' still runs",
                "first: left, right runs", "left at 0.000 m by place", "right at 0.300 m by place", "left: nothing",
                "refused: non-fatal error: invalid argument: no behaviour 'Fly', there is Ask, Go, Run",
                "refused: non-fatal error: invalid argument: start: the deployment has no robot 'nobody'", "left at ",
                " m by end-motion"});
}

TEST(Coordination, ProgramsExchangeMessagesThroughTheMp) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "messages"), {"left at ", " m by message", "left: nothing", "all have ended"});
}

TEST(Coordination, PartsOfATaskMoveTheirRobotsSimultaneously) {
  const ScratchFolder folder;
  const auto file = deployment(folder, "fibers", "[[answers]]\nquestion = \"Back?\"\nanswer = \"yes\"\n");
  const std::string output = expect_lines(file, {"mp: Back? yes", "both are there", "left 0.100 m, right 0.100 m"});
  // the instructions of the two parts overlap in time
  const auto trace = folder.path() / "trace.mcap";
  run_mrroc({"run", file.string(), "--quiet", "--record", trace.string()}, 0);
  std::vector<std::string> robots;
  for (const cli::trace::Line& line : steps_of(trace))
    if (!line.robots.empty()) robots.push_back(line.robots.front().name);
  robots.erase(std::unique(robots.begin(), robots.end()), robots.end());
  EXPECT_GT(robots.size(), 20U) << "the Moves were made one after the other";
}

TEST(Coordination, TwoPartsMustNotMoveOneRobot) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "shared"),
               {"refused: non-fatal error: the receiver is busy: another fiber moves this robot",
                "refused: non-fatal error: invalid argument: a fiber cannot have fibers", "left 0.000 m"});
}

TEST(Coordination, FailingPartStopsTheOthers) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "failing"), {"no part on the right", "left was stopped, 0.000 m/s"});
}

TEST(Coordination, QuestionsAreAnsweredByTheDeployment) {
  const ScratchFolder folder;
  const auto answer = [](const std::string& question, const std::string& text, const std::string& more = "") {
    return "[[answers]]\nquestion = \"" + question + "\"\nanswer = \"" + text + "\"\n" + more;
  };
  const auto file = deployment(folder, "questions",
                               answer("More?", "yes") + answer("More?", "no") + answer("How long?", "1.25") +
                                   answer("Where to?", "0.5", "process = \"right\"\n") +
                                   answer("Where to?", "0.04", "process = \"left\"\n"));
  // questions of one tick are shown in the order of processes
  expect_lines(file, {"left: Where to? 0.04", "left: On the way.", "No operator is left to answer"}, 1);
  expect_lines(file, {"mp: More? yes", "mp: More? no", "mp: How long? 1.25", "No operator is left to answer"}, 1);
  const std::string output = run_mrroc({"run", file.string(), "--quiet"}, 1);
  for (const std::string line :
       {"more 1, still more 0, length 1.25", "left at 0.040 m by answer",
        "coordination.toml:24: answers.answer: '1.25' is out of range, expected a number from 5 to 6 to 'How long?'",
        "0 choices of 'Which?', expected 1 to 8", "a text of 128 characters for the operator, expected 1 to 127"})
    EXPECT_NE(output.find(line), std::string::npos) << "'" << line << "' is missing in\n" << output;
}

std::string answers_but(const std::string& unanswered) {
  std::string text;
  for (const auto& [question, answer] : {std::pair{"More?", "yes"}, {"How long?", "1.25"}, {"Where to?", "0.04"}})
    if (question != unanswered)
      text += std::string{"[[answers]]\nquestion = \""} + question + "\"\nanswer = \"" + answer + "\"\n";
  return text;
}

/// Clock, and the unanswered question: "More?" is the MP's, "Where to?" an ECP's.
class Dialogue : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Dialogue, IsLeftWhenTheOperatorStopsTheTask) {
  const auto [clock, question] = GetParam();
  const ScratchFolder folder;
  const Keyboard keyboard;  // without input
  MrrocRun run({"run", deployment(folder, "questions", answers_but(question)).string(), "--clock", clock});
  ASSERT_TRUE(run.wait_for_output(question)) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), kStopped) << run.out() << run.err();
  EXPECT_NE(run.err().find("stopped by the operator"), std::string::npos) << run.err();
  EXPECT_EQ(run.out().find("does not end"), std::string::npos) << run.out();
  EXPECT_TRUE(all_end(pids));
}

INSTANTIATE_TEST_SUITE_P(All, Dialogue,
                         testing::Combine(testing::Values("paced", "real"), testing::Values("More?", "Where to?")),
                         [](const auto& test) {
                           const std::string question = std::get<1>(test.param);
                           return std::get<0>(test.param) + std::string{question == "More?" ? "_mp" : "_ecp"};
                         });

TEST(Coordination, AnswerDuringAPauseIsUsedAfterIt) {
  constexpr Tick kResume = 1500;
  const ScratchFolder folder;
  const auto file = deployment(folder, "questions",
                               answers_but("More?") + "[[events]]\ntick = 1\ncommand = \"pause\"\n" +
                                   "[[events]]\ntick = " + std::to_string(kResume) + "\ncommand = \"resume\"\n");
  const auto trace = folder.path() / "trace.mcap";
  Keyboard keyboard;
  MrrocRun run({"run", file.string(), "--clock", "paced", "--record", trace.string()});
  ASSERT_TRUE(run.wait_for_output("More?")) << run.out() << run.err();
  keyboard.type("yes\nyes\nyes\n");  // that one, the next, and "Is anybody there?"
  EXPECT_EQ(run.wait(), 0) << run.out() << run.err();
  EXPECT_NE(run.out().find("left at 0.040 m by answer"), std::string::npos) << run.out();
  const Steps of_left = steps_where(trace, [](const cli::trace::Line& line) { return line.process == "left"; });
  ASSERT_FALSE(of_left.empty());
  EXPECT_GE(of_left.front().tick, kResume) << of_left.front().name;
}

TEST(Coordination, PauseAndResumeReachThePartsAndThePrograms) {
  const ScratchFolder folder;
  const auto event = [](int tick, const std::string& command) {
    return "[[events]]\ntick = " + std::to_string(tick) + "\ncommand = \"" + command + "\"\n";
  };
  const std::string undisturbed = run_mrroc({"run", deployment(folder, "pause").string()}, 0);
  const auto file = deployment(folder, "pause", event(500, "pause") + event(2500, "resume"));
  expect_lines(file, {"left at 0.150 m by place", "right at 0.150 m"});
  const std::string paused = run_mrroc({"run", file.string()}, 0);
  const auto seconds = [](const std::string& output) {
    const std::string key = "coordination succeeded: ";
    return std::stod(output.substr(output.find(key) + key.size()));
  };
  EXPECT_NEAR(seconds(paused) - seconds(undisturbed), 4.0, 0.5);  // simulated: 2000 ticks and the two ramps
}

}  // namespace
}  // namespace mrroc::test::coordination_test
