#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "system/mrroc_run.hpp"

namespace mrroc::test::supervision_test {
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
  const std::string alone = (folder.path() / "alone.mcap").string();
  run_mrroc({"run", "tasks/press/press.toml", "--record", alone}, 0);
  for (int i = 0; i < 5; ++i) {
    const std::string first = (folder.path() / "first.mcap").string(),
                      second = (folder.path() / "second.mcap").string();
    run_two(
        {{{"run", "tasks/press/press.toml", "--record", first}, {"run", "tasks/press/press.toml", "--record", second}}},
        0);
    EXPECT_EQ(trace_hash(first), trace_hash(alone));
    EXPECT_EQ(trace_hash(second), trace_hash(alone));
  }
}

TEST(Supervision, RefusesADomainThatAnotherDeploymentUses) {
  const ScratchFolder folder;
  const auto file = press_with(folder, "domain = 77", "press.toml");
  MrrocRun first({"run", file.string(), "--clock", "paced"});
  ASSERT_TRUE(first.wait_for_output("mp           running")) << first.out() << first.err();
  const std::string output = run_mrroc({"run", file.string()}, kUsage);
  EXPECT_NE(output.find("DDS domain 77 is in use by another deployment on this host"), std::string::npos) << output;
  EXPECT_EQ(first.wait(), 0) << first.err();
  run_mrroc({"run", file.string()}, 0);  // free again
}

/// The DDS participants of a killed run are not known to have ended; the next run on the same domain ignores them.
TEST(Supervision, ParticipantsOfTheKilledRunDoNotDisturbTheNext) {
  const ScratchFolder folder;
  const auto file = press_with(folder, "domain = 78", "press.toml");
  const std::string trace = (folder.path() / "trace.mcap").string();
  run_mrroc({"run", file.string(), "--record", trace}, 0);
  const std::string hash = trace_hash(trace);
  for (int i = 0; i < 5; ++i) {
    MrrocRun killed({"run", file.string(), "--clock", "paced"});
    ASSERT_TRUE(killed.wait_for_output("mp           running")) << killed.out() << killed.err();
    const std::vector<pid_t> pids = killed.children();
    for (const pid_t pid : pids) kill(pid, SIGKILL);
    killed.signal(SIGKILL);
    killed.wait();
    EXPECT_TRUE(all_end(pids));
    run_mrroc({"run", file.string(), "--record", trace}, 0);
    EXPECT_EQ(trace_hash(trace), hash);
  }
}

/// UDP sockets on the RTPS ports (OMG DDSI-RTPS 2.3, 9.6.1.1) of the first `processes` of a domain, in use by
/// another program.
class ForeignProgram {
 public:
  ForeignProgram(int domain, int processes) {
    for (int port = 7400 + 250 * domain + 10; port < 7400 + 250 * domain + 10 + 2 * processes; ++port) {
      sockaddr_in address{};
      address.sin_family = AF_INET;
      address.sin_port = htons(static_cast<std::uint16_t>(port));
      sockets_.push_back(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
      EXPECT_EQ(bind(sockets_.back(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0) << port;
    }
  }
  ~ForeignProgram() {
    for (const int each : sockets_) close(each);
  }
  ForeignProgram(const ForeignProgram&) = delete;
  ForeignProgram& operator=(const ForeignProgram&) = delete;

 private:
  std::vector<int> sockets_;
};

TEST(Supervision, SkipsPortsThatAnotherProgramUses) {
  const ScratchFolder folder;
  const std::string alone = (folder.path() / "alone.mcap").string(), beside = (folder.path() / "beside.mcap").string();
  const auto file = press_with(folder, "domain = 79", "press.toml");
  run_mrroc({"run", file.string(), "--record", alone}, 0);
  const ForeignProgram foreign(79, 5);
  run_mrroc({"run", file.string(), "--record", beside}, 0);
  EXPECT_EQ(trace_hash(beside), trace_hash(alone));
}

TEST(Supervision, RefusesADomainWithoutAFreePort) {
  const ScratchFolder folder;
  const auto file = press_with(folder, "domain = 80", "press.toml");
  const ForeignProgram foreign(80, 61);
  const std::string output = run_mrroc({"run", file.string()}, kSystem);
  EXPECT_NE(output.find("DDS domain 80: no free port"), std::string::npos) << output;
}

/// The runner is stopped, so that it cannot detect the death. In lockstep no other process reacts to it; under the real
/// clock a stopped runner is itself a reason to end (silence_test).
TEST(Supervision, ZombieProcessIsNamed) {
  const ScratchFolder folder;
  MrrocRun run({"run", folder.write("hold.toml", faulty_deployment("hold", "lockstep")).string()});
  ASSERT_TRUE(run.wait_for_output("never")) << run.out() << run.err();
  const std::vector<pid_t> pids = run.children();
  const pid_t arm = run.child("arm_edp");
  run.signal(SIGSTOP);
  ASSERT_EQ(kill(arm, SIGKILL), 0);
  while (parent_of(arm) != -1) {
  }
  EXPECT_EQ(kill(arm, 0), 0) << "its entry in the table of processes remains";
  run.signal(SIGCONT);
  EXPECT_EQ(run.wait(), kSystem) << run.out() << run.err();
  EXPECT_NE(run.err().find("process arm_edp died: signal 9 (Killed)"), std::string::npos) << run.err();
  EXPECT_TRUE(all_end(pids));
}

class StartFailure : public testing::TestWithParam<std::pair<const char*, const char*>> {};

/// A program that is not part of the project.
TEST_P(StartFailure, IsNamedAndNoProcessRemains) {
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
                    std::pair{"#!/bin/sh\nexec sleep 60\n", "not ready within 3 s: arm"},
                    std::pair{"no program at all\n", "process arm died: exit code 127: cannot be executed"}),
    [](const auto& test) { return "Program" + std::to_string(test.index); });

}  // namespace
}  // namespace mrroc::test::supervision_test
