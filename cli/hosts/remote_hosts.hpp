#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/hosts/remote_host.hpp"
#include "config/deployment.hpp"

namespace mrroc::cli {

/// All other hosts of a run; most deployments have no other hosts. Main thread.
class RemoteHosts {
 public:
  /// Starts nothing yet. The deployment and the emergency stop, which those of the hosts follow, outlive it.
  RemoteHosts(const config::Deployment& deployment, HostListener listener, clock::EmergencyStop& emergency_stop);
  ~RemoteHosts();
  RemoteHosts(const RemoteHosts&) = delete;
  RemoteHosts& operator=(const RemoteHosts&) = delete;

  /// Starts an agent on each. `common`: the part of the order that is the same for all, the domain and what is to be
  /// recorded. Throws std::runtime_error that names a host without an address or a command; throws ConfigurationError
  /// when a host is not reached by the interface that the deployment names.
  void start_agents(const AgentOrder& common);

  /// This machine's address on the route to the others, and the addresses of all, this one's first; both empty when
  /// there are no others.
  const std::string& own_address() const noexcept { return own_address_; }
  const std::vector<std::string>& machines() const noexcept { return machines_; }

  /// Readable when `look` has something to do, or `also` is readable.
  int descriptor(int also);
  void poll();
  std::vector<std::string> missing() const;
  /// Agrees with all hosts on the time of tick 0, ns of this machine's CLOCK_MONOTONIC; 0 when there are no others.
  std::int64_t start();
  void stop();
  bool all_ended() noexcept;
  /// When the last step of a task arrived from any of them, CLOCK_MONOTONIC, ns; 0: never.
  std::int64_t step_at() const noexcept;
  /// Kills the commands that still run; returns the names of their hosts.
  std::vector<std::string> kill_rest() noexcept;
  /// A line for each, for the report.
  std::vector<std::string> summaries() const;
  /// Whether every press and reset of the runner's emergency stop has arrived at all hosts. Any thread.
  bool follow_emergency_stop() const noexcept;

 private:
  void check_interface(in_addr own) const;

  const config::Deployment& deployment_;
  HostListener listener_;
  clock::EmergencyStop& emergency_stop_;
  std::string own_address_;
  std::vector<std::string> machines_;
  std::deque<RemoteHost> hosts_;
  int wake_ = -1;  // epoll
};

}  // namespace mrroc::cli
