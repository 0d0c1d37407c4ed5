#include "cli/hosts/agent_protocol.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "cli/hosts/remote_host.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::agent_protocol_test {
namespace {

AgentOrder some_order() {
  AgentOrder order;
  order.host = "cell";
  order.deployment = "/a folder/press.toml";
  order.files = {{"deployment", "12ab"}, {"sim.scene", "0"}};
  order.domain = 7;
  order.machines = {"10.0.0.1", "10.0.0.2"};
  order.beat_port = 9350;
  order.key = new_beat_key();
  order.record = true;
  order.black_box = true;
  order.motion = "/a folder/motion";
  return order;
}

TEST(AgentOrder, RoundTrips) {
  const AgentOrder order = some_order();
  EXPECT_EQ(order_of_lines(to_lines(order)), order);
}

TEST(StepText, RoundTrips) {
  const recording::RecordedStep step{17, {std::byte{0}, std::byte{0xff}, std::byte{0x1a}}};
  EXPECT_EQ(to_text(step), "17 00ff1a");
  const auto read = step_of(to_text(step));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->tick, 17U);
  EXPECT_EQ(read->cdr, step.cdr);
  for (const char* const text : {"", "17 0", "17 0g", "x 00", "-1 00", "17 00 00", "17  00"})
    EXPECT_FALSE(step_of(text)) << text;
}

TEST(AgentOrder, RequiresEveryLine) {
  const auto lines = to_lines(some_order());
  for (const std::string needed : {"host", "deployment", "machine", "beat_port", "key"}) {
    std::vector<std::string> rest;
    for (const std::string& line : lines)
      if (split_word(line).first != needed) rest.push_back(line);
    EXPECT_THROW(order_of_lines(rest), std::runtime_error) << needed;
  }
}

RC_GTEST_PROP(AgentOrder, RefusesAnyOtherLine, (std::vector<std::string> lines)) {
  auto order = to_lines(some_order());
  const std::string line = *rc::gen::element<std::string>("", "domain", "domain 231", "domain -1", "beat_port x",
                                                          "key 00", "start 5", "hosts cell");
  order.push_back(line);
  RC_ASSERT_THROWS_AS(order_of_lines(order), std::runtime_error);
  lines.push_back(line);
  RC_ASSERT_THROWS_AS(order_of_lines(lines), std::runtime_error);
}

TEST(FilesOfARun, IncludeTheParametersThatTheDeploymentNames) {
  const task_test::ScratchFolder folder;
  config::Deployment deployment;
  deployment.file = folder.write("cell.toml", "");
  config::RobotEntry& robot = deployment.robots.emplace_back();
  robot.name = "belt";
  robot.type = "conveyor";
  robot.parameters = folder.write("fast.toml", "gear = 750\n");
  const auto before = files_of(deployment);
  ASSERT_EQ(before.size(), 2u);
  EXPECT_EQ(before[1].first, "robots.belt.parameters");
  folder.write("fast.toml", "gear = 751\n");
  EXPECT_EQ(files_of(deployment)[0], before[0]);
  EXPECT_NE(files_of(deployment)[1], before[1]);
}

TEST(FilesOfARun, IncludeTheCalibrationsThatTheDeploymentNames) {
  const task_test::ScratchFolder folder;
  config::Deployment deployment;
  deployment.file = folder.write("cell.toml", "");
  deployment.calibrations = {folder.write("wrist.toml", "mass = 1\n"), folder.write("eye.toml", "")};
  const auto before = files_of(deployment);
  ASSERT_EQ(before.size(), 3u);
  EXPECT_EQ(before[1].first, "deployment.calibration");
  folder.write("wrist.toml", "mass = 2\n");
  EXPECT_NE(files_of(deployment)[1], before[1]);
  EXPECT_EQ(files_of(deployment)[2], before[2]);
}

TEST(WholeNumber, AcceptsOnlyAWholeText) {
  EXPECT_EQ(whole_number("-12"), -12);
  EXPECT_EQ(whole_number("9223372036854775807"), INT64_MAX);
  for (const char* text : {"", " 1", "1 ", "1x", "x", "9223372036854775808", "0x1"})
    EXPECT_FALSE(whole_number(text)) << text;
}

TEST(AgentCommand, IsSshByDefault) {
  config::HostEntry host;
  host.address = "pc-2";
  host.mrroc = "/opt/it's here/mrroc";
  EXPECT_EQ(agent_command(host),
            (std::vector<std::string>{"ssh", "-T", "-o", "BatchMode=yes", "-o", "ConnectTimeout=10", "--", "pc-2",
                                      "'/opt/it'\\''s here/mrroc' agent"}));
  host.command = {"ip", "netns", "exec", "b"};
  EXPECT_EQ(agent_command(host),
            (std::vector<std::string>{"ip", "netns", "exec", "b", "/opt/it's here/mrroc", "agent"}));
}

}  // namespace
}  // namespace mrroc::cli::agent_protocol_test
