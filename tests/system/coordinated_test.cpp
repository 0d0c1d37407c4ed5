// Equation (11) of the paper: Moves of the MP in which the ECP of an arm takes part, with `mrroc run`.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "system/mrroc_run.hpp"

namespace mrroc::test::coordinated_test {
namespace {

std::filesystem::path deployment(const ScratchFolder& folder, const std::string& scenario,
                                 const std::string& more = "") {
  const std::string arm =
      "type = \"irb6\"\nhardware = \"loopback\"\nprogram = \"" MRROC_BINARY_DIR "/tests/coordinated_ecp\"\n";
  return folder.write("coordinated.toml", "[deployment]\nname = \"coordinated\"\n[mp]\nprogram = \"" MRROC_BINARY_DIR
                                          "/tests/coordinated_mp\"\n[robots.left]\n" +
                                              arm + "[robots.right]\n" + arm +
                                              "[[answers]]\nquestion = \"Which?\"\nanswer = \"" + scenario + "\"\n" +
                                              more);
}

std::string event(int tick, const std::string& command) {
  return "[[events]]\ntick = " + std::to_string(tick) + "\ncommand = \"" + command + "\"\n";
}

std::string content(const std::filesystem::path& file) {
  std::ifstream text(file);
  return {std::istreambuf_iterator<char>(text), {}};
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++found;
  return found;
}

/// The first of the lines that does not appear in this order; empty: all do.
std::string missing_line(const std::string& output, const std::vector<std::string>& lines) {
  std::size_t from = 0;
  for (const std::string& line : lines) {
    const std::size_t at = output.find(line, from);
    if (at == std::string::npos) return line;
    from = at + line.size();
  }
  return {};
}

/// The number behind `key` in `text`, 0 without one.
std::uint64_t number_behind(const std::string& text, const std::string& key) {
  const std::size_t at = text.find(key);
  return at == std::string::npos ? 0 : std::strtoull(text.c_str() + at + key.size(), nullptr, 10);
}

/// How many commands of a run with this trace came late: to a moving robot, which counts them, or to a resting one,
/// which then began after the start that the command had. An arm whose ECP leaves or holds it begins late, too, as
/// often in lockstep as under the real clock.
std::size_t late_commands(const std::string& trace) {
  std::size_t late = count(trace, " late=");
  std::map<std::string, std::uint64_t> starts;  // of the last commands, by process and robot
  std::istringstream lines(trace);
  for (std::string line; std::getline(lines, line);) {
    const std::string process = line.substr(0, line.find(" instruction=")).substr(line.find(" process=") + 1);
    for (std::size_t at = line.find(" robot="); at != std::string::npos;) {
      const std::size_t next = line.find(" robot=", at + 1);
      const std::string robot = line.substr(at, next == std::string::npos ? next : next - at);
      std::uint64_t& start = starts[process + robot.substr(0, robot.find(" tick="))];
      if (start != 0 && number_behind(robot, " macrostep=") > start) ++late;
      start = number_behind(robot, ",start");
      at = next;
    }
  }
  return late;
}

/// Runs it twice in lockstep and under the real clock. The traces keep the rules of `mrroc trace check`, in lockstep
/// they are equal. The lines appear in this order, in every run without more late commands than in lockstep: a busy
/// host, which may prevent that under the real clock, gets further runs. Returns the trace of the first run.
std::string expect_lines(const std::filesystem::path& file, const std::vector<std::string>& lines, int code = 0) {
  constexpr int kRunsUnderTheRealClock = 6;
  const ScratchFolder folder;
  const auto run = [&](const std::string& clock, const std::string& name) {
    return run_mrroc({"run", file.string(), "--quiet", "--clock", clock, "--trace", folder / name}, code);
  };
  for (const std::string name : {"0", "1"}) {
    const std::string output = run("lockstep", name);
    EXPECT_EQ(missing_line(output, lines), "") << "is missing in lockstep in\n" << output;
  }
  const std::string first = content(folder / "0");
  EXPECT_EQ(count(first, " late="), 0U);
  bool exact = false;
  for (int i = 0; i < kRunsUnderTheRealClock && !exact; ++i) {
    const std::string name = "real" + std::to_string(i), output = run("real", name);
    exact = late_commands(content(folder / name)) <= late_commands(first);
    if (exact) {
      EXPECT_EQ(missing_line(output, lines), "") << "is missing under the real clock in\n" << output;
    }
  }
  EXPECT_EQ(trace_hash(folder / "0"), trace_hash(folder / "1"));
  return first;
}

TEST(Coordinated, EcpThatCommandsWhatItsMpDoesChangesNothing) {
  const ScratchFolder folder;
  const std::string trace = expect_lines(deployment(folder, "mirror"), {"skew 0", "with the MP; difference 0.000000000",
                                                                        "transparent: difference 0.0000"});
  EXPECT_GT(count(trace, " superior=joint"), 100U);
  EXPECT_EQ(count(trace, " superior=joint"), count(trace, " coordinated command=joint"));
}

TEST(Coordinated, CorrectionIsAddedToTheMotionOfTheMp) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "corrected"), {"off by 4.000 mm, 4.000 mm in z"});
}

TEST(Coordinated, WithoutAWrenchAComplyingArmMovesAsTheMpDoes) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "comply"), {"carried, difference 0.000000000"});
}

TEST(Coordinated, GeneratorOfOnesOwnAddsToTheMotionOfTheMp) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "weave"), {"widest 2.0 mm"});
}

TEST(Coordinated, EcpThatEndsFirstLeavesTheMotionToTheMp) {
  const ScratchFolder folder;
  const std::string trace =
      expect_lines(deployment(folder, "first"), {"ended first: 20 steps", "on its own; difference 0.000000000"});
  EXPECT_EQ(count(trace, " held="), 1U) << "the MP brings both arms to rest and plans again";
}

TEST(Coordinated, ErrorOfTheEcpIsOneOfTheRobotInTheMove) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "error"),
               {"limit", "device left", "seen after few ticks", "limit", "process left",
                "refused: non-fatal error: the task failed: it was to throw [process mp, device left", "moving: 0 0",
                "refused: non-fatal error: the task failed: it was to throw [process left", "transparent"});
}

TEST(Coordinated, EcpMayStayForSeveralMoves) {
  const ScratchFolder folder;
  const std::string trace = expect_lines(deployment(folder, "stay"), {"stayed: ", "6 plans", "difference 0.000000000"});
  EXPECT_EQ(count(trace, "move=\"Mirroring\" until"), 0U);
}

TEST(Coordinated, EcpWithAProgramOfItsOwnIsBusy) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "busy"), {"refused: non-fatal error: the receiver is busy"});
}

TEST(Coordinated, PauseOfTheMpHoldsAndTheMotionContinues) {
  const ScratchFolder folder;
  const std::string trace = expect_lines(deployment(folder, "mirror", event(400, "pause") + event(900, "resume")),
                                         {"mirrored: ", "4 plans, with the MP; difference 0.000000000"});
  EXPECT_GT(count(trace, " superior=hold"), 10U);
}

TEST(Coordinated, StopEndsBothPrograms) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "mirror", event(400, "stop")), {}, 5);
}

TEST(Coordinated, LostMpEndsTheRunAndTheArmsRest) {
  const ScratchFolder folder;
  const auto file = deployment(folder, "mirror");
  for (const std::string what : {"kill mp at tick 300", "kill ecp:left at tick 300", "lose mp at step 40"}) {
    const std::string output = run_mrroc({"run", file.string(), "--quiet", "--inject", what}, 4);
    EXPECT_EQ(output.find("limit"), std::string::npos) << what << ":\n" << output;
  }
}

/// Late commands of either side: the arms brake, the MP's generator plans again, and they arrive together.
TEST(Coordinated, LateCommandsAreMadeUpFor) {
  const ScratchFolder folder;
  const auto file = deployment(folder, "mirror");
  for (const std::string what :
       {"delay mp by 40 at step 30 for 10 ticks", "delay ecp:left by 40 at step 30 for 10 ticks"}) {
    const auto trace = folder.path() / "trace";
    const std::string output =
        run_mrroc({"run", file.string(), "--quiet", "--inject", what, "--trace", trace.string()}, 0);
    EXPECT_NE(output.find("with the MP; difference 0.000000000"), std::string::npos) << what << ":\n" << output;
    EXPECT_GT(count(content(trace), " late="), 0U) << what;
  }
}

/// The ECP's motion begins again with the path that the MP plans after it has braked.
TEST(Coordinated, LateCommandsOfAGeneratorOfOnesOwnAreMadeUpFor) {
  const ScratchFolder folder;
  const auto file = deployment(folder, "weave");
  for (const std::string process : {"mp", "ecp:left"})
    for (const std::string step : {"20", "40", "75"}) {
      const std::string what = "delay " + process + " by 5 at step " + step + " for 10 ticks";
      const auto trace = folder.path() / "trace";
      const std::string output =
          run_mrroc({"run", file.string(), "--quiet", "--inject", what, "--trace", trace.string()}, 0);
      EXPECT_NE(output.find("widest 2.0 mm"), std::string::npos) << what << ":\n" << output;
      EXPECT_GT(count(content(trace), " late="), 0U) << what;
    }
}

}  // namespace
}  // namespace mrroc::test::coordinated_test
