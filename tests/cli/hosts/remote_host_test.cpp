#include "cli/hosts/remote_host.hpp"

#include <gtest/gtest.h>
#include <poll.h>

#include <string>
#include <vector>

#include "cli/processes/addresses.hpp"
#include "clock/wall/monotonic.hpp"

namespace mrroc::cli::remote_host_test {
namespace {

/// The runner's end of another host, whose agent's clock jumps ahead at the start. The times are far longer than the
/// delays of a busy machine.
class HostWithAClock {
 public:
  explicit HostWithAClock(int milliseconds_ahead) {
    listener_.message = [](const std::string&) {};
    listener_.failed = [this](process::ExitCode code, const std::string& reason) {
      failures_.push_back(std::to_string(static_cast<int>(code)) + " " + reason);
    };
    config::HostEntry entry;
    entry.name = "cell";
    entry.address = "127.0.0.1";
    entry.command = {MRROC_BINARY_DIR "/tests/drifting_agent", std::to_string(milliseconds_ahead)};
    AgentOrder order;
    order.host = entry.name;
    order.deployment = "none.toml";
    order.domain = 91;
    order.machines = {entry.address, entry.address};
    const in_addr here = ipv4_of(entry.address);
    host_.emplace(entry, order, here, here, HostLimits{.link_timeout = 10, .clock_error = 1}, listener_,
                  emergency_stop_);
    while (failures_.empty() && !host_->missing().empty()) poll();
    host_->start(clock::monotonic_ns());
  }

  void poll() {
    ::poll(nullptr, 0, 1);
    host_->poll();
  }
  const std::vector<std::string>& failures() const { return failures_; }
  std::string summary() const { return host_->summary(); }

 private:
  std::vector<std::string> failures_;
  HostListener listener_;
  clock::EmergencyStop emergency_stop_;
  std::optional<RemoteHost> host_;
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

}  // namespace
}  // namespace mrroc::cli::remote_host_test
