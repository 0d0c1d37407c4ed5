#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "repetitions.hpp"
#include "system/cable.hpp"
#include "system/keyboard.hpp"
#include "system/mrroc_run.hpp"

namespace mrroc::test {
namespace {

constexpr int kUsage = 2;
constexpr int kSystem = 4;

/// A machine that is busy with something else is silent for longer than the 50 ms that are usual.
constexpr const char* kPatient = "link_timeout = 2\n";

void pause_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string in_toml(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + "\"";
  return "[" + text + "]";
}

/// The operator and the MP on host a, robot, sensors and simulated world on host b, called `cell`.
class TwoHosts : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string refusal = lay(cable_); !refusal.empty()) GTEST_SKIP() << refusal;
  }

  /// What the deployments have in common; `limits` are more lines of [deployment].
  std::string hosts(const std::string& name, const std::string& limits, std::vector<std::string> command = {},
                    const std::string& more = "") const {
    if (command.empty()) command = cable_->b().command();
    return "[deployment]\nname = \"" + name + "\"\nclock = \"real\"\n" + limits +
           "[network]\ninterface = \"cable0\"\n" + network_ +
           "\n"
           "[hosts.cell]\naddress = \"" +
           Cable::kAddressOfB + "\"\ncommand = " + in_toml(command) + "\n" + more;
  }

  /// The task press_mp: every step goes over the cable.
  static std::string press() {
    return "[mp]\nprogram = \"press_mp\"\n"
           "[robots.arm]\ntype = \"irb6\"\nhardware = \"mujoco\"\nhost = \"cell\"\nposition = [0.0, 0.0, 0.7]\n"
           "[sensors.wrist]\ntype = \"force_torque\"\nrobot = \"arm\"\n"
           "[sensors.gate]\ntype = \"ultrasonic\"\nmode = \"non-interactive\"\nrate = 50\n"
           "[sim]\nscene = \"" MRROC_SOURCE_DIR "/tasks/press/press.xml\"\n";
  }

  /// A robot with loopback drives whose task never ends.
  static std::string hold() {
    return "[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\nhost = \"cell\"\nprogram = \"" MRROC_BINARY_DIR
           "/tests/faulty_ecp\"\n";
  }

  std::filesystem::path write(const std::string& text) const { return folder_.write("two.toml", text); }

  MrrocRun& start(const std::filesystem::path& deployment, const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments{"run", deployment.string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Inside inside(cable_->a());
    return run_.emplace(arguments);
  }

  std::string output() const { return run_->out() + run_->err(); }

  /// The run ends with this code, its last words contain `cause`, or one of `causes`, and nothing is left on either
  /// host.
  void expect_end(int code, const std::string& cause, const std::vector<pid_t>& pids) {
    expect_end(code, std::vector<std::string>{cause}, pids);
  }
  void expect_end(int code, const std::vector<std::string>& causes, const std::vector<pid_t>& pids) {
    EXPECT_EQ(run_->wait(), code) << output();
    const auto told = [this](const std::string& cause) { return contains(run_->err(), cause); };
    EXPECT_TRUE(std::any_of(causes.begin(), causes.end(), told)) << output();
    EXPECT_TRUE(all_end(pids)) << output();
  }

  std::string network_ = "security = false";
  ScratchFolder folder_;
  std::optional<Cable> cable_;
  std::optional<MrrocRun> run_;
};

TEST_F(TwoHosts, DoATaskTogetherWithKeys) {
  run_mrroc({"keys", (folder_.path() / "keys").string()}, 0);
  network_ = "keys = \"keys\"";
  const auto trace = folder_.path() / "press.trace";
  start(write(hosts("two", kPatient, {}, press())), {"--trace", trace.string()});
  EXPECT_EQ(run_->wait(), 0) << output();
  EXPECT_TRUE(contains(run_->out(), "two succeeded")) << output();
  EXPECT_TRUE(contains(run_->out(), "clock known to")) << output();
  EXPECT_GT(cable_->counts().carried, 1000U);
  expect_laws(trace);
}

TEST_F(TwoHosts, GoOnOverABadCable) {
  const auto trace = folder_.path() / "press.trace";
  cable_->set({.delay = 0.005, .jitter = 0.002, .loss = 0.02, .duplicate = 0.02, .reorder = 0.02});
  start(write(hosts("two", "link_timeout = 2\nclock_error = 0.02\n", {}, press())), {"--trace", trace.string()});
  EXPECT_EQ(run_->wait(MrrocRun::kLongPatience), 0) << output();
  const Cable::Counts counts = cable_->counts();
  EXPECT_GT(counts.lost, 20U);
  EXPECT_GT(counts.duplicated, 20U);
  EXPECT_GT(counts.reordered, 20U);
  expect_laws(trace);
}

TEST_F(TwoHosts, DropWhatIsCorrupted) {
  cable_->set({.corrupt = 0.05});
  start(write(hosts("two", kPatient, {}, press())));
  EXPECT_EQ(run_->wait(), 0) << output();
  EXPECT_GT(cable_->counts().corrupted, 50U);
}

TEST_F(TwoHosts, StopBothWhenTheCableIsCut) {
  MrrocRun& run = start(write(hosts("two", "link_timeout = 0.2\n", {}, press())));
  ASSERT_TRUE(run.wait_for_output("JointLine")) << output();
  pause_for(0.3);
  const std::vector<pid_t> pids = run.descendants();
  EXPECT_GE(pids.size(), 7U);
  cable_->set({.cut = true});
  expect_end(kSystem, "lost: nothing heard for 0.2", pids);
}

TEST_F(TwoHosts, BearAShortCut) {
  MrrocRun& run = start(write(hosts("two", kPatient, {}, press())));
  ASSERT_TRUE(run.wait_for_output("JointLine")) << output();
  cable_->set({.cut = true});
  pause_for(0.15);
  cable_->set({});
  EXPECT_EQ(run.wait(), 0) << output();
  EXPECT_GT(cable_->counts().lost, 10U);
}

/// Of two arms the one that keeps still is on host a: what stops the other stops it, too.
TEST_F(TwoHosts, StopARobotOnEitherSide) {
  const std::string second = "[robots.second]\ntype = \"irb6\"\nhardware = \"loopback\"\nprogram = \"" MRROC_BINARY_DIR
                             "/tests/faulty_ecp\"\n";
  MrrocRun& run = start(write(hosts("hold", kPatient, {}, hold() + second)));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  pause_for(0.3);
  const std::vector<pid_t> pids = run.descendants();
  ASSERT_EQ(parent_of(run.descendant("second_edp")), run.pid());
  cable_->set({.cut = true});
  expect_end(kSystem, "lost: nothing heard for 2", pids);
  EXPECT_FALSE(contains(run.out(), "killing it")) << output();
}

TEST_F(TwoHosts, NameADeadProcessWithItsHost) {
  MrrocRun& run = start(write(hosts("hold", kPatient, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  ASSERT_GT(run.descendant("arm_edp"), 0);
  kill(run.descendant("arm_edp"), SIGKILL);
  expect_end(kSystem, "process arm_edp on host cell died: signal 9 (Killed)", pids);
}

TEST_F(TwoHosts, NameADeadAgent) {
  MrrocRun& run = start(write(hosts("hold", kPatient, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  const pid_t agent = parent_of(run.descendant("arm_edp"));
  ASSERT_GT(agent, 0);
  kill(agent, SIGKILL);
  std::vector<std::string> causes{"host cell: its agent is gone: signal 9 (Killed)"};
  // its channel closes after the kernel has freed its memory: with a sanitizer's terabytes the beats may be missed
  // before
  if (kSanitized) causes.emplace_back("host cell: link lost: nothing heard for 2 s");
  expect_end(kSystem, causes, pids);
}

TEST_F(TwoHosts, NameAStoppedAgent) {
  MrrocRun& run = start(write(hosts("hold", kPatient, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  kill(parent_of(run.descendant("arm_edp")), SIGSTOP);
  expect_end(kSystem, "host cell: link lost: nothing heard for 2 s", pids);
}

TEST_F(TwoHosts, LeaveNothingWhenTheRunnerIsKilled) {
  MrrocRun& run = start(write(hosts("hold", kPatient, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  run.signal(SIGKILL);
  EXPECT_EQ(run.wait(), -SIGKILL);
  EXPECT_TRUE(all_end(pids));
}

TEST_F(TwoHosts, StopForTheOperator) {
  MrrocRun& run = start(write(hosts("hold", kPatient, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  run.signal(SIGINT);
  expect_end(5, "stopped by the operator", pids);
}

TEST_F(TwoHosts, HaveClocksOfTheirOwn) {
  // host b has been up for a thousand seconds more
  std::vector<std::string> command = cable_->b().command();
  for (const char* word : {"unshare", "--time", "--monotonic", "1000", "--fork", "--kill-child", "--"})
    command.emplace_back(word);
  start(write(hosts("two", kPatient, command, press())));
  EXPECT_EQ(run_->wait(), 0) << output();
}

TEST_F(TwoHosts, RefuseAClockThatIsKnownTooBadly) {
  cable_->set({.delay = 0.01});
  start(write(hosts("two", "start_timeout = 10\nlink_timeout = 0.2\n", {}, press())));
  EXPECT_EQ(run_->wait(), kSystem) << output();
  EXPECT_TRUE(contains(run_->err(), "not ready within 10")) << output();
  EXPECT_TRUE(contains(run_->err(), "the clock of host cell (known to 10.")) << output();
}

TEST_F(TwoHosts, RefuseAnInterfaceThatDoesNotLeadToTheHost) {
  {
    const Inside inside(cable_->a());
    ASSERT_EQ(std::system("ip link add other0 type veth peer name other1 && ip address add 10.78.0.1/24 dev other0 && "
                          "ip link set other1 up && ip link set other0 up"),
              0);
  }
  std::string text = hosts("two", "", {}, hold());
  const std::string named = "interface = \"cable0\"";
  start(write(text.replace(text.find(named), named.size(), "interface = \"other0\"")));
  EXPECT_EQ(run_->wait(), kUsage) << output();
  EXPECT_TRUE(
      contains(run_->err(), "network.interface: 'other0' has the address 10.78.0.1, and the way to the host begins at"))
      << output();
}

/// A table that somebody has mended on one machine only.
TEST_F(TwoHosts, RefuseFilesThatDiffer) {
  const ScratchFolder other;
  const std::string text =
      hosts("two", "", {}, "folder = \"" + other.path().string() + "\"\n") +
      "[robots.arm]\ntype = \"irb6\"\nhardware = \"socketcan\"\nhost = \"cell\"\nprogram = \"" MRROC_BINARY_DIR
      "/tests/faulty_ecp\"\n[robots.arm.can]\ninterface = \"can0\"\ndrives = \"arm_drives.toml\"\n";
  std::ifstream file(MRROC_SOURCE_DIR "/robots/irb6/irb6_drives.toml");
  const std::string table{std::istreambuf_iterator<char>(file), {}};
  other.write("two.toml", text);
  folder_.write("arm_drives.toml", table);
  other.write("arm_drives.toml", table + "# mended\n");
  start(write(text));
  EXPECT_EQ(run_->wait(), kUsage) << output();
  EXPECT_TRUE(
      contains(run_->err(), "robots.arm.can.drives: the file differs from the one on the machine of the runner"))
      << output();
}

TEST_F(TwoHosts, StopForAnEmergency) {
  Keyboard keyboard;
  MrrocRun& run = start(write(hosts("hold", kPatient, {}, hold())));
  ASSERT_TRUE(run.wait_for_output("never")) << output();
  const std::vector<pid_t> pids = run.descendants();
  keyboard.type("estop\n");
  expect_end(5, "emergency stop: it ends a run with several hosts", pids);
}

struct Mistake {
  const char* name;
  std::vector<std::string> command;
  std::string host;  // more lines of [hosts.cell]
  std::string message;
  int code;
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

class TwoHostsMistaken : public TwoHosts, public testing::WithParamInterface<Mistake> {};

TEST_P(TwoHostsMistaken, SayItInOneLine) {
  const Mistake& mistake = GetParam();
  start(write(hosts("two", kPatient, mistake.command, mistake.host + press())));
  EXPECT_EQ(run_->wait(), mistake.code) << output();
  EXPECT_TRUE(contains(run_->err(), mistake.message)) << output();
  const std::string error = run_->err().substr(run_->err().find("mrroc: "));  // behind the warning about keys
  EXPECT_EQ(error.find('\n'), error.size() - 1) << output();
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, TwoHostsMistaken,
    testing::Values(
        Mistake{"no_command", {"no_such_program"}, "", "host cell: no program 'no_such_program'", kSystem},
        Mistake{"command_fails", {"false"}, "", "host cell: no agent could be started: exit code 1", kSystem},
        Mistake{
            "another_version",
            {"sh", "-c", "echo mrroc-agent 1 0.0.0"},
            "",
            "host cell: another version of MRROC++ is installed there: 'mrroc-agent 1 0.0.0', expected 'mrroc-agent 1 ",
            kUsage},
        Mistake{"no_mrroc",
                {},
                "mrroc = \"/nowhere/mrroc\"\n",
                "host cell: no agent could be started: exit code 127: nsenter: failed to execute /nowhere/mrroc: No "
                "such file or directory",
                kSystem},
        Mistake{"no_deployment",
                {},
                "folder = \"/nowhere\"\n",
                "host cell: /nowhere/two.toml: does not exist, expected a readable file",
                kUsage}),
    [](const auto& test) { return std::string{test.param.name}; });

}  // namespace
}  // namespace mrroc::test
