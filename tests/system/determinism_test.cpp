#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "repetitions.hpp"
#include "system/mrroc_run.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::determinism_test {
namespace {

/// Hashes of runs in lockstep, the second half of them with two busy loops at the same time.
std::set<std::string> hashes_of(const std::string& deployment, const std::filesystem::path& trace) {
  std::set<std::string> hashes;
  std::unique_ptr<Load> load;
  const int runs = tries(8, 20);
  for (int i = 0; i < runs; ++i) {
    if (i == runs / 2) load = std::make_unique<Load>(2);
    run_mrroc({"run", deployment, "--clock", "lockstep", "--quiet", "--record", trace.string()}, 0);
    hashes.insert(trace_hash(trace));
  }
  return hashes;
}

using Commands = std::map<std::uint64_t, std::vector<cli::trace::CommandEntry>>;

/// The commands of the robot in each instruction, in order.
Commands commands_of(const std::filesystem::path& trace) {
  Commands commands;
  for (const cli::trace::Line& line : steps_of(trace))
    if (!line.robots.empty() && line.robots.front().command)
      commands[line.instruction].push_back(*line.robots.front().command);
  return commands;
}

TEST(Determinism, AllRunsOfPressGiveOneTraceUnderAnyLoad) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "press.mcap";
  EXPECT_EQ(hashes_of("tasks/press/press.toml", trace).size(), 1U);
  const Steps steps = steps_of(trace);
  const auto any = [&steps](auto fits) { return std::any_of(steps.begin(), steps.end(), fits); };
  using cli::trace::Line;
  EXPECT_TRUE(any([](const Line& line) { return !line.is_move && line.name == "gate closer than 0.1 m"; }));
  EXPECT_TRUE(any([](const Line& line) { return line.is_move && line.name == "ToolVelocity"; }));
  EXPECT_TRUE(any([](const Line& line) { return line.process == "arm"; }));
  EXPECT_FALSE(any([](const Line& line) { return line.process == "mp"; }));
}

TEST(Determinism, TraceIsIndependentOfTheOutputAndTheOrderOfStart) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "press.mcap";
  const std::string deployment = "tasks/press/press.toml";
  run_mrroc({"run", deployment, "--record", trace.string()}, 0);
  std::set<std::string> hashes{trace_hash(trace)};
  for (int seed = 1; seed <= 5; ++seed) {
    run_mrroc({"run", deployment, "--quiet", "--shuffle-start", std::to_string(seed), "--record", trace.string()}, 0);
    hashes.insert(trace_hash(trace));
  }
  EXPECT_EQ(hashes.size(), 1U);
}

TEST(Determinism, AnotherWorldGivesAnotherTrace) {
  const ScratchFolder folder;
  const auto press = folder.path() / "press.mcap";
  const auto replay = folder.path() / "replay.mcap";
  run_mrroc({"run", "tasks/press/press.toml", "--quiet", "--record", press.string()}, 0);
  run_mrroc({"run", "tasks/press_replay/press_replay.toml", "--quiet", "--record", replay.string()}, 0);
  EXPECT_NE(trace_hash(press), trace_hash(replay));
}

TEST(Determinism, AllRunsOfPressMpGiveOneTraceUnderAnyLoad) {
  const ScratchFolder folder;
  EXPECT_EQ(hashes_of("tasks/press_mp/press_mp.toml", folder.path() / "press_mp.mcap").size(), 1U);
}

TEST(Determinism, GeneratorCommandsTheSameInAnEcpAndInTheMp) {
  const ScratchFolder folder;
  const auto ecp = folder.path() / "ecp.mcap";
  const auto mp = folder.path() / "mp.mcap";
  run_mrroc({"run", "tasks/press/press.toml", "--quiet", "--record", ecp.string()}, 0);
  run_mrroc({"run", "tasks/press_mp/press_mp.toml", "--quiet", "--record", mp.string()}, 0);
  const auto commands = commands_of(ecp);
  EXPECT_EQ(commands.size(), 6U);
  EXPECT_EQ(commands, commands_of(mp));
}

}  // namespace
}  // namespace mrroc::test::determinism_test
