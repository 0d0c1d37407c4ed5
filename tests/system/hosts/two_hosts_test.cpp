#include "system/hosts/two_hosts.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "cli/trace/trace_steps.hpp"
#include "system/trace_steps_of.hpp"

namespace mrroc::test::two_hosts_test {
namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(TwoHostsWithKeys, RunATaskTogether) {
  const auto trace = file("press.mcap");
  start_until("running", write(hosts("two", kPatientLink, {}, press())), {"--record", trace.string()});
  EXPECT_EQ(run_->wait(), 0) << output();
  EXPECT_TRUE(contains(run_->out(), "two succeeded")) << output();
  EXPECT_TRUE(contains(run_->out(), "clock known to")) << output();
  EXPECT_GT(cable_->counts().carried, 1000U);
  expect_laws(trace);
}

/// The task runs on the other host, and its process sends every step to the runner.
TEST_F(TwoHosts, StepsOfATaskOnTheOtherHostAreRecorded) {
  const auto recording = file("caught.mcap");
  start(write(hosts("caught", kPatientLink, {}, hold())), {"--record", recording.string()});  // that task ends
  EXPECT_EQ(run_->wait(), 0) << output();
  expect_laws(recording);
  const Steps steps = steps_where(recording, [](const cli::trace::Line& line) { return line.process == "arm"; });
  ASSERT_FALSE(steps.empty()) << output();
  EXPECT_EQ(steps.front().instruction, 1U) << "the first step is recorded";
  EXPECT_EQ(steps.front().step, 0U);
  EXPECT_EQ(steps.back().name, "JointLine") << "the last step is recorded";
  EXPECT_EQ(steps.back().ending, StepEnding::generator);
  for (const cli::trace::Line& line : steps) EXPECT_NE(robot_in(line, "arm"), nullptr) << line.name << " " << line.step;
  int ends = 0;
  for (const cli::trace::Item& item : cli::trace::read_trace(recording).items)
    if (const auto* const end = std::get_if<cli::trace::ProcessEnd>(&item); end != nullptr && end->process == "arm") {
      ++ends;
      EXPECT_EQ(end->lines, steps.size());
      EXPECT_EQ(end->dropped, 0U);
    }
  EXPECT_EQ(ends, 1);
}

TEST_F(TwoHosts, RefuseToRecordServoTicks) {
  start(write(hosts("two", kPatientLink, {}, press())),
        {"--record", file("press.mcap").string(), "--record-rate", "servo"});
  EXPECT_EQ(run_->wait(), kUsage) << output();
  EXPECT_TRUE(contains(run_->err(),
                       "two.toml: --record-rate servo: host 'cell' is another machine, expected "
                       "--record-rate step"))
      << output();
  EXPECT_FALSE(std::filesystem::exists(file("press.mcap")));
}

/// Devices of usual machines; the addresses of the hosts stay the same.
struct Devices {
  const char* name;
  std::vector<std::string> a, b;  ///< commands of iproute2 on the hosts
  int mtu = 1500;
  const char* interface = Cable::kDevice;
};

void PrintTo(const Devices& devices, std::ostream* out) { *out << devices.name; }

class TwoHostsWithDevices : public TwoHosts, public testing::WithParamInterface<Devices> {};

TEST_P(TwoHostsWithDevices, WorkTogether) {
  const Devices& devices = GetParam();
  for (const std::string& command : devices.a) cable_->a().ip(command);
  for (const std::string& command : devices.b) cable_->b().ip(command);
  cable_->set_mtu(devices.mtu);
  std::string text = hosts("robot_type", kPatientLink, {}, hold());  // the task ends with an error of its own
  const std::string usual = "interface = \"cable0\"";
  text.replace(text.find(usual), usual.size(), std::string{"interface = \""} + devices.interface + "\"");
  start(write(text));
  EXPECT_EQ(run_->wait(), 1) << output();
}

INSTANTIATE_TEST_SUITE_P(
    Devices, TwoHostsWithDevices,
    testing::Values(Devices{"WithoutMulticast", {"link set cable0 multicast off"}, {"link set cable0 multicast off"}},
                    Devices{"WithoutMulticastOnOneHost", {"link set cable0 multicast off"}, {}},
                    Devices{"OfMtu576", {}, {}, 576}, Devices{"OfMtu9000", {}, {}, 9000},
                    Devices{"WithAnotherAddressFirst",
                            {"address flush dev cable0", "address add 192.168.7.1/24 dev cable0",
                             "address add 10.77.0.1/24 dev cable0"},
                            {"address flush dev cable0", "address add 192.168.8.1/24 dev cable0",
                             "address add 10.77.0.2/24 dev cable0"}},
                    Devices{"ByAddress", {"address add 192.168.7.1/24 dev cable0"}, {}, 1500, Cable::kAddressOfA},
                    Devices{"PointToPoint",
                            {"address flush dev cable0", "link set cable0 multicast off",
                             "address add 10.77.0.1 peer 10.77.0.2 dev cable0"},
                            {"address flush dev cable0", "link set cable0 multicast off",
                             "address add 10.77.0.2 peer 10.77.0.1 dev cable0"}}),
    [](const auto& test) { return test.param.name; });

TEST_F(TwoHosts, HaveSeparateClocks) {
  // host b has an uptime that is a thousand seconds longer
  std::vector<std::string> command = cable_->b().command();
  for (const char* word : {"unshare", "--time", "--monotonic", "1000", "--fork", "--kill-child", "--"})
    command.emplace_back(word);
  start(write(hosts("two", kPatientLink, command, press())));
  EXPECT_EQ(run_->wait(), 0) << output();
}

TEST_F(TwoHosts, RefuseAClockWithALargeUncertainty) {
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
  EXPECT_TRUE(contains(run_->err(),
                       "network.interface: 'other0' has the address 10.78.0.1, but the route to the host begins at"))
      << output();
}

/// A table that was edited on one machine only.
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
  other.write("arm_drives.toml", table + "# repaired\n");
  start(write(text));
  EXPECT_EQ(run_->wait(), kUsage) << output();
  EXPECT_TRUE(
      contains(run_->err(), "robots.arm.can.drives: the file differs from the one on the machine of the runner"))
      << output();
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

TEST_P(TwoHostsMistaken, ReportErrorsInOneLine) {
  const Mistake& mistake = GetParam();
  start(write(hosts("two", kPatientLink, mistake.command, mistake.host + press())));
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
            {"sh", "-c", "echo mrroc-agent 2 0.0.0"},
            "",
            "host cell: another version of MRROC++ is installed there: 'mrroc-agent 2 0.0.0', expected 'mrroc-agent 2 ",
            kUsage},
        Mistake{
            "another_protocol",
            {"sh", "-c", "echo mrroc-agent 1 0.2.0"},
            "",
            "host cell: another version of MRROC++ is installed there: 'mrroc-agent 1 0.2.0', expected 'mrroc-agent 2 ",
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
}  // namespace mrroc::test::two_hosts_test
