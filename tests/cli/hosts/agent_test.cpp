#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/hosts/agent_protocol.hpp"
#include "cli/hosts/line_channel.hpp"
#include "cli/processes/child.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::agent_test {
namespace {

using Lines = std::vector<std::string>;

/// `mrroc agent` and the runner's end of its channel.
class RunningAgent {
 public:
  explicit RunningAgent(const Lines& command = {"agent"})
      : ends_(make_ends()),
        agent_("agent", MRROC_BINARY_DIR "/bin/mrroc", command, ends_[1]),
        channel_(ends_[0], ends_[0]) {
    close(ends_[1]);
  }

  LineChannel& channel() { return channel_; }
  Child& process() { return agent_; }

  /// Reads its output until a line starts with the text, or it has ended.
  void hear(const std::string& begin) {
    for (bool ended = false; !ended && !has_said(begin);) {
      ended = agent_.ended();
      pollfd entry{channel_.fd(), POLLIN, 0};
      poll(&entry, 1, 20);
      for (std::string& line : channel_.read()) lines_.push_back(std::move(line));
    }
  }
  bool has_said(const std::string& begin) const {
    return std::any_of(lines_.begin(), lines_.end(), [&](const std::string& line) { return line.starts_with(begin); });
  }
  /// Reads its output to the end; returns all of it.
  const Lines& hear_out() {
    while (!agent_.ended()) hear("\n");
    hear("\n");
    return lines_;
  }

 private:
  static std::vector<int> make_ends() {
    std::vector<int> ends(2, -1);
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
    return ends;
  }

  std::vector<int> ends_;
  Child agent_;
  LineChannel channel_;
  Lines lines_;
};

TEST(Agent, EndsBySignalBeforeItHasAnOrder) {
  RunningAgent agent;
  agent.hear("mrroc-agent");
  agent.process().signal(SIGTERM);
  EXPECT_EQ(agent.hear_out(),
            (Lines{std::string{kAgentGreeting}, "failed 4 its agent was ended by signal 15", "ended"}));
  EXPECT_EQ(agent.process().exit_code(), 4);
}

TEST(Agent, EndsWhenItsRunnerGoesBeforeTheOrder) {
  RunningAgent agent;
  agent.hear("mrroc-agent");
  agent.channel().finish();
  agent.hear_out();
  EXPECT_EQ(agent.process().exit_code(), 2);
}

TEST(Agent, TimesOutWithoutAnOrder) {
  RunningAgent agent({"agent", "--order-within", "0.25"});
  agent.channel().write("host cell");  // the order begins, but `go` never comes
  EXPECT_EQ(agent.hear_out(), (Lines{std::string{kAgentGreeting}, "failed 4 no order within 0.25 s", "ended"}));
  EXPECT_EQ(agent.process().exit_code(), 4);
}

/// A simulator waits for no other process before the start.
TEST(Agent, TimesOutWithoutAStart) {
  const task_test::ScratchFolder folder;
  AgentOrder order;
  order.host = "cell";
  order.deployment = folder.write("cell.toml",
                                  "[deployment]\nname = \"cell\"\nclock = \"real\"\nstart_timeout = 1\n"
                                  "[network]\nsecurity = false\n"
                                  "[hosts.cell]\naddress = \"127.0.0.1\"\n"
                                  "[robots.arm]\ntype = \"irb6\"\nhardware = \"loopback\"\n"
                                  "program = \"irb6_demo\"\n"
                                  "[sim]\nscene = \"" MRROC_SOURCE_DIR "/tasks/press/press.xml\"\nhost = \"cell\"\n");
  order.domain = 200;
  order.machines = {"127.0.0.1", "127.0.0.1"};
  order.beat_port = 9;
  order.key = new_beat_key();
  RunningAgent agent;
  for (const std::string& line : to_lines(order)) agent.channel().write(line);
  agent.channel().write("go");
  const Lines& output = agent.hear_out();
  const auto failed =
      std::find_if(output.begin(), output.end(), [](const std::string& line) { return line.starts_with("failed"); });
  ASSERT_NE(failed, output.end()) << testing::PrintToString(output);
  EXPECT_TRUE(failed->starts_with("failed 4 not started in time")) << *failed;
  EXPECT_EQ(output.back(), "ended");
  EXPECT_EQ(agent.process().exit_code(), 4);
}

}  // namespace
}  // namespace mrroc::cli::agent_test
