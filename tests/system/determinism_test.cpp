#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <memory>
#include <set>

#include "repetitions.hpp"
#include "system/mrroc_run.hpp"
#include "text_of.hpp"

namespace mrroc::test::determinism_test {
namespace {

/// Hashes of runs in lockstep, the second half of them with two busy loops at the same time.
std::set<std::string> hashes_of(const std::string& deployment, const std::filesystem::path& trace) {
  std::set<std::string> hashes;
  std::unique_ptr<Load> load;
  const int runs = tries(8, 20);
  for (int i = 0; i < runs; ++i) {
    if (i == runs / 2) load = std::make_unique<Load>(2);
    run_mrroc({"run", deployment, "--clock", "lockstep", "--quiet", "--trace", trace.string()}, 0);
    hashes.insert(trace_hash(trace));
  }
  return hashes;
}

/// The commands of the robot in each instruction, in order.
std::map<std::string, std::vector<std::string>> commands_of(const std::filesystem::path& trace) {
  std::map<std::string, std::vector<std::string>> commands;
  std::ifstream file(trace);
  for (std::string line; std::getline(file, line);) {
    const std::size_t instruction = line.find(" instruction=");
    const std::size_t command = line.find(" command=");
    if (instruction == std::string::npos || command == std::string::npos) continue;
    const auto word = [&line](std::size_t at) { return line.substr(at + 1, line.find(' ', at + 1) - at - 1); };
    commands[word(instruction)].push_back(word(command));
  }
  return commands;
}

TEST(Determinism, AllRunsOfPressGiveOneTraceUnderAnyLoad) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "press.trace";
  EXPECT_EQ(hashes_of("tasks/press/press.toml", trace).size(), 1U);
  const std::string text = text_of(trace);
  EXPECT_NE(text.find("wait=\"gate closer than 0.1 m\""), std::string::npos);
  EXPECT_NE(text.find("move=\"ToolVelocity\""), std::string::npos);
  EXPECT_NE(text.find("process=arm"), std::string::npos);
  EXPECT_EQ(text.find("process=mp instruction="), std::string::npos);
}

TEST(Determinism, TraceIsIndependentOfTheOutputAndTheOrderOfStart) {
  const ScratchFolder folder;
  const auto trace = folder.path() / "press.trace";
  const std::string deployment = "tasks/press/press.toml";
  run_mrroc({"run", deployment, "--trace", trace.string()}, 0);
  std::set<std::string> hashes{trace_hash(trace)};
  for (int seed = 1; seed <= 5; ++seed) {
    run_mrroc({"run", deployment, "--quiet", "--shuffle-start", std::to_string(seed), "--trace", trace.string()}, 0);
    hashes.insert(trace_hash(trace));
  }
  EXPECT_EQ(hashes.size(), 1U);
}

TEST(Determinism, AnotherWorldGivesAnotherTrace) {
  const ScratchFolder folder;
  const auto press = folder.path() / "press";
  const auto replay = folder.path() / "replay";
  run_mrroc({"run", "tasks/press/press.toml", "--quiet", "--trace", press.string()}, 0);
  run_mrroc({"run", "tasks/press_replay/press_replay.toml", "--quiet", "--trace", replay.string()}, 0);
  EXPECT_NE(trace_hash(press), trace_hash(replay));
}

TEST(Determinism, AllRunsOfPressMpGiveOneTraceUnderAnyLoad) {
  const ScratchFolder folder;
  EXPECT_EQ(hashes_of("tasks/press_mp/press_mp.toml", folder.path() / "press_mp.trace").size(), 1U);
}

TEST(Determinism, GeneratorCommandsTheSameInAnEcpAndInTheMp) {
  const ScratchFolder folder;
  const auto ecp = folder.path() / "ecp";
  const auto mp = folder.path() / "mp";
  run_mrroc({"run", "tasks/press/press.toml", "--quiet", "--trace", ecp.string()}, 0);
  run_mrroc({"run", "tasks/press_mp/press_mp.toml", "--quiet", "--trace", mp.string()}, 0);
  const auto commands = commands_of(ecp);
  EXPECT_EQ(commands.size(), 6U);
  EXPECT_EQ(commands, commands_of(mp));
}

}  // namespace
}  // namespace mrroc::test::determinism_test
