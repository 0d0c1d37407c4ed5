#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

constexpr int kUsage = 2, kSystem = 4;

/// A copy of tasks/press with further keys of [deployment].
std::filesystem::path press_with(const ScratchFolder& folder, const std::string& keys, const std::string& name) {
  std::ifstream file(std::string{MRROC_SOURCE_DIR} + "/tasks/press/press.toml");
  std::stringstream text;
  text << file.rdbuf();
  std::string copy = text.str();
  copy.insert(copy.find("[deployment]\n") + 13, keys + "\n");
  std::filesystem::copy_file(std::string{MRROC_SOURCE_DIR} + "/tasks/press/press.xml", folder.path() / "press.xml",
                             std::filesystem::copy_options::overwrite_existing);
  return folder.write(name, copy);
}

TEST(Supervision, TwoDeploymentsOnOneHostDoNotDisturbEachOther) {
  const ScratchFolder folder;
  const std::string alone = (folder.path() / "alone").string();
  run_mrroc({"run", "tasks/press/press.toml", "--trace", alone}, 0);
  for (int i = 0; i < 5; ++i) {
    const std::string first = (folder.path() / "first").string(), second = (folder.path() / "second").string();
    run_two(
        {{{"run", "tasks/press/press.toml", "--trace", first}, {"run", "tasks/press/press.toml", "--trace", second}}},
        0);
    EXPECT_EQ(trace_hash(first), trace_hash(alone));
    EXPECT_EQ(trace_hash(second), trace_hash(alone));
  }
}

TEST(Supervision, ADomainThatAnotherDeploymentHasIsRefused) {
  const ScratchFolder folder;
  const auto file = press_with(folder, "domain = 77", "press.toml");
  MrrocRun first({"run", file.string(), "--clock", "paced"});
  ASSERT_TRUE(first.wait_for_output("mp           running")) << first.out() << first.err();
  const std::string output = run_mrroc({"run", file.string()}, kUsage);
  EXPECT_NE(output.find("DDS domain 77 is in use by another deployment on this host"), std::string::npos) << output;
  EXPECT_EQ(first.wait(), 0) << first.err();
  run_mrroc({"run", file.string()}, 0);  // free again
}

/// The DDS participants of a run that was killed are not known to be gone; the next one on the same domain does not
/// listen to them.
TEST(Supervision, ARunIsNotDisturbedByTheGhostsOfTheOneBefore) {
  const ScratchFolder folder;
  const auto file = press_with(folder, "domain = 78", "press.toml");
  const std::string trace = (folder.path() / "trace").string();
  run_mrroc({"run", file.string(), "--trace", trace}, 0);
  const std::string hash = trace_hash(trace);
  for (int i = 0; i < 5; ++i) {
    MrrocRun killed({"run", file.string(), "--clock", "paced"});
    ASSERT_TRUE(killed.wait_for_output("mp           running")) << killed.out() << killed.err();
    const std::vector<pid_t> pids = killed.children();
    for (const pid_t pid : pids) kill(pid, SIGKILL);
    killed.signal(SIGKILL);
    killed.wait();
    EXPECT_TRUE(all_end(pids));
    run_mrroc({"run", file.string(), "--trace", trace}, 0);
    EXPECT_EQ(trace_hash(trace), hash);
  }
}

class StartFailure : public testing::TestWithParam<std::pair<const char*, const char*>> {};

/// A program that is no program of ours.
TEST_P(StartFailure, IsNamedAndNothingIsLeft) {
  const auto [script, reason] = GetParam();
  const ScratchFolder folder;
  const auto program = folder.write("program", script);
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const auto file = folder.write("cell.toml",
                                 "[deployment]\nname = \"cell\"\nstart_timeout = 3\n[robots.arm]\ntype = \"irb6\"\n"
                                 "hardware = \"loopback\"\nprogram = \"" +
                                     program.string() + "\"\n");
  MrrocRun run({"run", file.string()});
  EXPECT_EQ(run.wait(), kSystem) << run.out() << run.err();
  EXPECT_NE(run.err().find(reason), std::string::npos) << run.err();
}

INSTANTIATE_TEST_SUITE_P(
    Programs, StartFailure,
    testing::Values(std::pair{"#!/bin/sh\nexit 0\n", "process arm died: exit code 0"},
                    std::pair{"#!/bin/sh\nkill -SEGV $$\n", "process arm died: signal 11 (Segmentation fault)"},
                    std::pair{"#!/bin/sh\necho no robot here >&2\nexit 9\n",
                              "process arm died: exit code 9: no robot here"},
                    std::pair{"#!/bin/sh\nexec sleep 60\n", "not ready within 3.000000 s: arm"},
                    std::pair{"no program at all\n", "process arm died: exit code 127: cannot be executed"}),
    [](const auto& test) { return "Program" + std::to_string(test.index); });

}  // namespace
}  // namespace mrroc::test
