// Equation (11) of the paper: Moves of the MP in which the ECP of an arm takes part, with `mrroc run`.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"

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

using cli::trace::RobotEntry;

/// How many states of robots in the steps fit.
template <class Fits>
std::size_t count(const Steps& steps, Fits fits) {
  std::size_t found = 0;
  for (const cli::trace::Line& line : steps)
    found += static_cast<std::size_t>(std::count_if(line.robots.begin(), line.robots.end(), fits));
  return found;
}

bool has_late_commands(const RobotEntry& robot) { return robot.late != 0; }

/// Whether the MP commands so in the step of an ECP.
auto superior_is(CommandKind kind) {
  return [kind](const RobotEntry& robot) { return robot.superior && robot.superior->kind == kind; };
}

/// Whether an ECP that takes part in a Move of the MP commands joints.
bool commands_joints_with_the_mp(const RobotEntry& robot) {
  return robot.coordination == Coordination::takes_part && robot.command && robot.command->kind == CommandKind::joint;
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

/// The start tick of a robot's command, or else of the MP's; 0 without one.
Tick start_of(const RobotEntry& robot) {
  if (robot.command && robot.command->start_tick != 0) return robot.command->start_tick;
  return robot.superior ? robot.superior->start_tick : 0;
}

/// How many commands of a run with these steps came late: to a moving robot, which counts them, or to a resting one,
/// which then began after the start that the command had. An arm whose ECP leaves or holds it begins late, too, as
/// often in lockstep as under the real clock.
std::size_t late_commands(const Steps& steps) {
  std::size_t late = count(steps, has_late_commands);
  std::map<std::pair<std::string, std::string>, Tick> starts;  // of the last commands, by process and robot
  for (const cli::trace::Line& line : steps)
    for (const RobotEntry& robot : line.robots) {
      Tick& start = starts[{line.process, robot.name}];
      if (start != 0 && robot.macrostep > start) ++late;
      start = start_of(robot);
    }
  return late;
}

/// Runs it twice in lockstep and under the real clock. The recordings keep the rules of `mrroc trace check`, in
/// lockstep they are equal. The lines appear in this order, in every run without more late commands than in lockstep: a
/// busy host, which may prevent that under the real clock, gets further runs. Returns the steps of the first run.
Steps expect_lines(const std::filesystem::path& file, const std::vector<std::string>& lines, int code = 0) {
  constexpr int kRunsUnderTheRealClock = 6;
  const ScratchFolder folder;
  const auto run = [&](const std::string& clock, const std::string& name) {
    return run_mrroc({"run", file.string(), "--quiet", "--clock", clock, "--record", folder / name}, code);
  };
  for (const std::string name : {"0.mcap", "1.mcap"}) {
    const std::string output = run("lockstep", name);
    EXPECT_EQ(missing_line(output, lines), "") << "is missing in lockstep in\n" << output;
  }
  Steps first = steps_of(folder / "0.mcap");
  EXPECT_EQ(count(first, has_late_commands), 0U);
  bool exact = false;
  for (int i = 0; i < kRunsUnderTheRealClock && !exact; ++i) {
    const std::string name = "real" + std::to_string(i) + ".mcap", output = run("real", name);
    exact = late_commands(steps_of(folder / name)) <= late_commands(first);
    if (exact) {
      EXPECT_EQ(missing_line(output, lines), "") << "is missing under the real clock in\n" << output;
    }
  }
  EXPECT_EQ(trace_hash(folder / "0.mcap"), trace_hash(folder / "1.mcap"));
  return first;
}

TEST(Coordinated, EcpThatCommandsWhatItsMpDoesChangesNothing) {
  const ScratchFolder folder;
  const Steps steps = expect_lines(deployment(folder, "mirror"),
                                   {"skew 0", "with the MP; difference 0.000000000", "transparent: difference 0.0000"});
  EXPECT_GT(count(steps, superior_is(CommandKind::joint)), 100U);
  EXPECT_EQ(count(steps, superior_is(CommandKind::joint)), count(steps, commands_joints_with_the_mp));
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
  const Steps steps =
      expect_lines(deployment(folder, "first"), {"ended first: 20 steps", "on its own; difference 0.000000000"});
  EXPECT_EQ(std::count_if(steps.begin(), steps.end(), [](const cli::trace::Line& line) { return line.held != 0; }), 1)
      << "the MP brings both arms to rest and plans again";
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
  const Steps steps = expect_lines(deployment(folder, "stay"), {"stayed: ", "6 plans", "difference 0.000000000"});
  EXPECT_TRUE(std::none_of(steps.begin(), steps.end(), [](const cli::trace::Line& line) {
    return line.is_move && line.name == "Mirroring" && line.until;
  }));
}

TEST(Coordinated, EcpWithAProgramOfItsOwnIsBusy) {
  const ScratchFolder folder;
  expect_lines(deployment(folder, "busy"), {"refused: non-fatal error: the receiver is busy"});
}

TEST(Coordinated, PauseOfTheMpHoldsAndTheMotionContinues) {
  const ScratchFolder folder;
  const Steps steps = expect_lines(deployment(folder, "mirror", event(400, "pause") + event(900, "resume")),
                                   {"mirrored: ", "4 plans, with the MP; difference 0.000000000"});
  EXPECT_GT(count(steps, superior_is(CommandKind::hold)), 10U);
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
    const auto trace = folder.path() / "trace.mcap";
    const std::string output =
        run_mrroc({"run", file.string(), "--quiet", "--inject", what, "--record", trace.string()}, 0);
    EXPECT_NE(output.find("with the MP; difference 0.000000000"), std::string::npos) << what << ":\n" << output;
    EXPECT_GT(count(steps_of(trace), has_late_commands), 0U) << what;
  }
}

/// The ECP's motion begins again with the path that the MP plans after it has braked.
TEST(Coordinated, LateCommandsOfAGeneratorOfOnesOwnAreMadeUpFor) {
  const ScratchFolder folder;
  const auto file = deployment(folder, "weave");
  for (const std::string process : {"mp", "ecp:left"})
    for (const std::string step : {"20", "40", "75"}) {
      const std::string what = "delay " + process + " by 5 at step " + step + " for 10 ticks";
      const auto trace = folder.path() / "trace.mcap";
      const std::string output =
          run_mrroc({"run", file.string(), "--quiet", "--inject", what, "--record", trace.string()}, 0);
      EXPECT_NE(output.find("widest 2.0 mm"), std::string::npos) << what << ":\n" << output;
      EXPECT_GT(count(steps_of(trace), has_late_commands), 0U) << what;
    }
}

}  // namespace
}  // namespace mrroc::test::coordinated_test
