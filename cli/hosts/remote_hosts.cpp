#include "cli/hosts/remote_hosts.hpp"

#include <sys/epoll.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "cli/processes/addresses.hpp"
#include "clock/wall/monotonic.hpp"
#include "config/table.hpp"
#include "links/transport/network_interface.hpp"

namespace mrroc::cli {

namespace {

/// From the agreement on tick 0 to tick 0: time for the message to reach every host, and for all processes to wake up.
constexpr std::int64_t kLead = clock::kSecond / 5;

void add_to(int wake, int fd) {
  epoll_event event{};
  event.events = EPOLLIN;
  epoll_ctl(wake, EPOLL_CTL_ADD, fd, &event);
}

std::filesystem::path deployment_on(const config::HostEntry& host, const std::filesystem::path& here) {
  return host.folder.empty() ? here : host.folder / here.filename();
}

}  // namespace

RemoteHosts::RemoteHosts(const config::Deployment& deployment, HostListener listener,
                         clock::EmergencyStop& emergency_stop)
    : deployment_(deployment), listener_(std::move(listener)), emergency_stop_(emergency_stop) {}

RemoteHosts::~RemoteHosts() {
  if (wake_ >= 0) close(wake_);
}

/// DDS uses the interface that the deployment names, everything else follows the kernel's routes.
void RemoteHosts::check_interface(in_addr own) const {
  const std::string& named = deployment_.network.interface;
  if (named.empty()) return;
  const links::NetworkInterface interface = links::find_interface(named);
  // compared by device: a device may have several addresses
  if (interface.index == links::find_interface(to_text(own)).index) return;
  throw config::ConfigurationError(
      deployment_.file, 0, "network.interface",
      "'" + named + "' has the address " + interface.address + ", but the route to the host begins at " + to_text(own),
      "the interface that leads to the hosts");
}

void RemoteHosts::start_agents(const AgentOrder& common) {
  const auto used = deployment_.hosts_used();
  std::vector<in_addr> there;
  for (const config::HostEntry* host : used) {
    try {
      there.push_back(ipv4_of(host->address));
      if (machines_.empty()) machines_.push_back(own_address_ = to_text(own_address_towards(there.back())));
      machines_.push_back(to_text(there.back()));
      check_interface(own_address_towards(there.back()));
    } catch (const config::ConfigurationError&) {
      throw;
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("host " + host->name + ": " + error.what());
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    AgentOrder order = common;
    order.host = used[i]->name;
    order.deployment = deployment_on(*used[i], deployment_.file);
    order.files = files_of(deployment_);
    order.machines = machines_;
    try {
      const in_addr own = own_address_towards(there[i]);
      order.machines.front() = to_text(own);
      hosts_.emplace_back(*used[i], order, own, there[i], HostLimits{deployment_.link_timeout, deployment_.clock_error},
                          listener_, emergency_stop_);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("host " + used[i]->name + ": " + error.what());
    }
  }
}

int RemoteHosts::descriptor(int also) {
  if (hosts_.empty()) return also;
  if (wake_ < 0) {
    wake_ = epoll_create1(EPOLL_CLOEXEC);
    add_to(wake_, also);
    for (const RemoteHost& host : hosts_)
      for (const int fd : host.descriptors()) add_to(wake_, fd);
  }
  return wake_;
}

void RemoteHosts::poll() {
  for (RemoteHost& host : hosts_) host.poll();
}

std::vector<std::string> RemoteHosts::missing() const {
  std::vector<std::string> all;
  for (const RemoteHost& host : hosts_) {
    const auto missing = host.missing();
    all.insert(all.end(), missing.begin(), missing.end());
  }
  return all;
}

std::int64_t RemoteHosts::start() {
  if (hosts_.empty()) return 0;
  std::int64_t error = 0;
  for (const RemoteHost& host : hosts_) error = std::max(error, host.clock_error_ns());
  const std::int64_t epoch = clock::monotonic_ns() + kLead + 10 * error;
  for (RemoteHost& host : hosts_) host.start(epoch);
  return epoch;
}

void RemoteHosts::stop() {
  for (RemoteHost& host : hosts_) host.stop();
}

bool RemoteHosts::all_ended() noexcept {
  return std::all_of(hosts_.begin(), hosts_.end(), [](RemoteHost& host) { return host.ended(); });
}

std::int64_t RemoteHosts::step_at() const noexcept {
  std::int64_t latest = 0;
  for (const RemoteHost& host : hosts_) latest = std::max(latest, host.step_at());
  return latest;
}

std::vector<std::string> RemoteHosts::kill_rest() noexcept {
  std::vector<std::string> names;
  for (RemoteHost& host : hosts_) {
    if (host.ended()) continue;
    names.push_back(host.name());
    host.kill();
  }
  return names;
}

std::vector<std::string> RemoteHosts::summaries() const {
  std::vector<std::string> lines;
  for (const RemoteHost& host : hosts_) lines.push_back(host.summary());
  return lines;
}

bool RemoteHosts::follow_emergency_stop() const noexcept {
  return std::all_of(hosts_.begin(), hosts_.end(),
                     [](const RemoteHost& host) { return host.follows_emergency_stop(); });
}

}  // namespace mrroc::cli
