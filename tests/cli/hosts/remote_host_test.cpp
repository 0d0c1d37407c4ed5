#include "cli/hosts/remote_host.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>

#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/processes/addresses.hpp"
#include "clock/wall/monotonic.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::cli::remote_host_test {
namespace {

/// The runner's end of another host, whose agent is started on this machine by `command`. The times are far longer than
/// the delays of a busy machine.
class HostHere {
 public:
  explicit HostHere(
      std::vector<std::string> command, std::function<void(const std::string&)> message = [](const std::string&) {}) {
    listener_.message = std::move(message);
    listener_.failed = [this](process::ExitCode code, const std::string& reason) {
      failures_.push_back(std::to_string(static_cast<int>(code)) + " " + reason);
    };
    config::HostEntry entry;
    entry.name = "cell";
    entry.address = "127.0.0.1";
    entry.command = std::move(command);
    AgentOrder order;
    order.host = entry.name;
    order.deployment = "none.toml";
    order.domain = 91;
    order.machines = {entry.address, entry.address};
    const in_addr here = ipv4_of(entry.address);
    host_.emplace(entry, order, here, here, HostLimits{.link_timeout = 10, .clock_error = 1}, listener_,
                  emergency_stop_);
  }

  void poll() {
    ::poll(nullptr, 0, 1);
    host_->poll();
  }
  RemoteHost& host() { return *host_; }
  const std::vector<std::string>& failures() const { return failures_; }
  std::string summary() const { return host_->summary(); }

 private:
  std::vector<std::string> failures_;
  HostListener listener_;
  clock::EmergencyStop emergency_stop_;
  std::optional<RemoteHost> host_;
};

/// Its agent's clock jumps ahead at the start.
class HostWithAClock : public HostHere {
 public:
  explicit HostWithAClock(int milliseconds_ahead)
      : HostHere({MRROC_BINARY_DIR "/tests/drifting_agent", std::to_string(milliseconds_ahead)}) {
    while (failures().empty() && !host().missing().empty()) poll();
    host().start(clock::monotonic_ns());
  }
};

TEST(RemoteHost, FailsWhenTheClocksCertainlyDifferTooMuch) {
  HostWithAClock host(3000);
  while (host.failures().empty()) host.poll();
  EXPECT_TRUE(host.failures().front().starts_with("4 host cell: clock lost: its clock has moved by "))
      << host.failures().front();
  EXPECT_TRUE(host.failures().front().ends_with(" ms since the start, more than clock_error = 1000 ms"))
      << host.failures().front();
}

TEST(RemoteHost, ToleratesADriftWithinTheLimit) {
  HostWithAClock host(300);
  while (host.failures().empty() && host.summary().find("drift 0 us") != std::string::npos) host.poll();
  EXPECT_EQ(host.failures(), std::vector<std::string>{}) << host.summary();
  EXPECT_NE(host.summary().find("drift "), std::string::npos) << host.summary();
}

/// The failures of a host whose agent sends `last_words` and ends with exit code 0 after the runner has read the
/// channel, and before the runner asks the kernel about the agent.
std::vector<std::string> failures_after(const std::string& last_words) {
  const task_test::ScratchFolder scratch;
  const std::string order_to_end = scratch / "end";
  const auto end_agent = [&order_to_end](const std::string&) {
    std::ofstream{order_to_end};
    siginfo_t end{};
    waitid(P_ALL, 0, &end, WEXITED | WNOWAIT);
  };
  HostHere host(
      {"sh", "-c", R"(echo "$1"; echo "line mp at work"; while [ ! -e "$2" ]; do sleep 0.01; done; printf %b "$3")",
       "sh", std::string{kAgentGreeting}, order_to_end, last_words},
      end_agent);
  while (!host.host().ended()) host.poll();
  host.poll();
  return host.failures();
}

TEST(RemoteHost, HearsTheLastWordsOfAnAgentBeforeItsEnd) {
  EXPECT_EQ(failures_after("ended\\n"), std::vector<std::string>{});
  EXPECT_EQ(failures_after("failed 3 clock lost\\nended\\n"), std::vector<std::string>{"3 host cell: clock lost"});
}

TEST(RemoteHost, FailsWhenItsAgentEndsWithoutAWord) {
  EXPECT_EQ(failures_after(""), std::vector<std::string>{"4 host cell: its agent is gone: exit code 0"});
}

}  // namespace
}  // namespace mrroc::cli::remote_host_test
