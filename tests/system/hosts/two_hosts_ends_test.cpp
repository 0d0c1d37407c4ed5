// Death or stop of a process on either host, and requests for the end or for an emergency stop.
#include <gtest/gtest.h>
#include <signal.h>

#include <cstdio>
#include <string>
#include <vector>

#include "mrroc/types.hpp"
#include "repetitions.hpp"
#include "system/hosts/two_hosts.hpp"
#include "system/keyboard.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::two_hosts_ends_test {
namespace {

/// The ECP on that host ends because of it, and its last steps are transmitted.
TEST_F(TwoHosts, NameADeadProcessWithItsHost) {
  MrrocRun& run = start(write(hosts("hold", kPatientLink, {}, hold())), {"--black-box", file("boxes").string()});
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  ASSERT_GT(run.descendant("arm_edp"), 0);
  kill(run.descendant("arm_edp"), SIGKILL);
  expect_end(kSystem, "process arm_edp on host cell died: signal 9 (Killed)", pids);
  const auto box = file("boxes") / "hold-arm.mcap";
  EXPECT_NE(run.out().find("black box: " + box.string()), std::string::npos) << output();
  expect_laws(box);
  const Steps steps = steps_where(box, [](const cli::trace::Line& line) { return line.process == "arm"; });
  ASSERT_FALSE(steps.empty()) << output();
  EXPECT_EQ(steps.back().name, "never");
}

TEST_F(TwoHosts, NameAStoppedProcessWithItsHost) {
  MrrocRun& run = start(write(hosts("hold", kPatientLink, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  ASSERT_GT(run.descendant("arm_edp"), 0);
  kill(run.descendant("arm_edp"), SIGSTOP);
  expect_end(kSystem, "process arm_edp on host cell is stopped by signal 19 (Stopped (signal))", pids);
}

TEST_F(TwoHosts, NameADeadAgent) {
  MrrocRun& run = start(write(hosts("hold", kPatientLink, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  const pid_t agent = parent_of(run.descendant("arm_edp"));
  ASSERT_GT(agent, 0);
  kill(agent, SIGKILL);
  std::vector<std::string> causes{"host cell: its agent is gone: signal 9 (Killed)"};
  // its channel closes after the kernel has freed its memory: with a sanitizer's terabytes the heartbeats may be missed
  // before
  if (kSanitized) causes.emplace_back("host cell: link lost: nothing received for 2 s");
  expect_end(kSystem, causes, pids);
}

TEST_F(TwoHosts, NameAStoppedAgent) {
  MrrocRun& run = start(write(hosts("hold", kPatientLink, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  kill(parent_of(run.descendant("arm_edp")), SIGSTOP);
  expect_end(kSystem, "host cell: link lost: nothing received for 2 s", pids);
}

/// Its processes have left before; their ends are only a consequence.
TEST_F(TwoHosts, NameAnAgentThatWasStoppedAndContinues) {
  MrrocRun& run = start(write(hosts("hold", kPatientLink, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  const pid_t agent = parent_of(run.descendant("arm_edp"));
  kill(agent, SIGSTOP);
  pause_for(0.3);
  kill(agent, SIGCONT);
  expect_end(kSystem, "host cell: its agent was stopped by a signal", pids);
}

TEST_F(TwoHosts, LeaveNothingWhenTheRunnerIsKilled) {
  MrrocRun& run = start(write(hosts("hold", kPatientLink, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  run.signal(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  EXPECT_TRUE(all_end(pids));
}

TEST_F(TwoHosts, StopForTheOperator) {
  MrrocRun& run = start(write(hosts("hold", kPatientLink, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  run.signal(SIGINT);
  expect_end(5, "stopped by the operator", pids);
}

/// The tick at which a robot's program reported the pressed emergency stop; 0: it has not reported it.
Tick emergency_at(const std::string& output, const std::string& robot) {
  const std::string text = robot + " | stopped: hardware error: the emergency stop is pressed or not reset: at tick ";
  const std::size_t place = output.find(text);
  return place == std::string::npos ? 0 : std::stoull(output.substr(place + text.size()));
}

/// An arm on either host, each moved by its own program there, which checks that no joint moves before the reset and
/// `recover()`; the cable has disturbances.
TEST_F(TwoHosts, StopForAnEmergencyAndContinue) {
  Keyboard keyboard;
  const std::string arm =
      "type = \"irb6\"\nhardware = \"loopback\"\nprogram = \"" MRROC_BINARY_DIR "/tests/emergency_stop_ecp\"\n";
  MrrocRun& run =
      start(write(hosts("both", kPatientLink) + "[robots.here]\n" + arm + "[robots.there]\nhost = \"cell\"\n" + arm));
  ASSERT_TRUE(run.wait_for_output("here | moves")) << output();
  ASSERT_TRUE(run.wait_for_output("there | moves")) << output();
  pause_for(0.5);
  cable_->set({.loss = 0.1, .duplicate = 0.1, .reorder = 0.1});
  keyboard.type("estop\n");
  ASSERT_TRUE(run.wait_for_output("here | stopped: ")) << output();
  ASSERT_TRUE(run.wait_for_output("there | stopped: ")) << output();
  pause_for(1.5);
  EXPECT_FALSE(run.has_ended()) << output();
  keyboard.type("reset\n");
  EXPECT_EQ(run.wait(), 0) << output();
  const Tick here = emergency_at(run.out(), "here"), there = emergency_at(run.out(), "there");
  std::printf("pressed here at tick %llu, there at %llu\n", static_cast<unsigned long long>(here),
              static_cast<unsigned long long>(there));
  EXPECT_GT(here, 0U) << output();
  EXPECT_GT(there, 0U) << output();
  EXPECT_LT(there, here + 1000) << "a link that is silent for 2 s is lost";
  for (const char* went_on : {"here | went on", "there | went on"})
    EXPECT_NE(run.out().find(went_on), std::string::npos) << output();
}

/// As on one machine, it is a hardware error.
TEST_F(TwoHosts, EndOnAnUncaughtEmergencyStop) {
  Keyboard keyboard;
  MrrocRun& run = start(write(hosts("hold", kPatientLink, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  keyboard.type("estop\n");
  expect_end(kHardware, "hardware error: the emergency stop is pressed or not reset", pids);
}

}  // namespace
}  // namespace mrroc::test::two_hosts_ends_test
