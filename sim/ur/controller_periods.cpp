// The periods of the controller: on its own clock, or one in each tick of lockstep.
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <chrono>

#include "clock/wall/sliced_wait.hpp"
#include "sim/ur/controller_client.hpp"
#include "sim/ur/realtime_message.hpp"
#include "sim/ur/robot_state_message.hpp"

namespace mrroc::sim::ur {

namespace {

constexpr std::size_t kMostQueued = 1 << 20;  // bytes of a client that does not read
constexpr int kStatePeriods = 50;             // of the primary and secondary interfaces
constexpr int kPeriodsOfCb3 = 4;              // of 2 ms

}  // namespace

void ControllerServers::step() {
  controller_.step();
  ++steps_;
  send_packages();
  for (int* const rest : {&lose_, &repeat_, &delay_})
    if (*rest > 0) --*rest;
}

ControllerServers::Period ControllerServers::advance(std::int64_t timeout) {
  std::unique_lock lock(mutex_);
  controller_.measure();
  send_packages();
  for (Client& client : clients_) flush(client);
  // the thread sends what a socket has not taken
  if (std::any_of(clients_.begin(), clients_.end(), [](const Client& client) { return !client.queued.empty(); }))
    wake();
  const auto answered = [this] { return answered_ == static_cast<std::int32_t>(steps_ + 1); };
  const bool over = clock::wait_in_slices(timeout, [&](std::int64_t deadline) {
    const std::chrono::steady_clock::time_point end{std::chrono::nanoseconds(deadline)};
    return answered_or_gone_.wait_until(lock, end, [&] { return answered() || !has_driver(); });
  });
  const Period period = answered() ? Period::answered : over ? Period::without_driver : Period::unanswered;
  controller_.step();
  ++steps_;
  return period;
}

bool ControllerServers::has_driver() const {
  return std::any_of(clients_.begin(), clients_.end(),
                     [](const Client& client) { return client.drives && !client.ended; });
}

/// The packages and messages of this period.
void ControllerServers::send_packages() {
  const bool loses = lose_ > 0 || (lose_every_ > 0 && steps_ % static_cast<std::uint64_t>(lose_every_) == 0);
  for (Client& client : clients_) {
    if (client.service == Service::rtde && client.started && steps_ % client.every == 0 && !loses) send_state(client);
    const bool states = client.service == Service::primary || client.service == Service::secondary;
    if (states && steps_ % kStatePeriods == 0) send(client, robot_state_message(controller_));
    const std::uint64_t realtime_periods = is_e_series(controller_.version()) ? 1 : kPeriodsOfCb3;
    if (client.service == Service::realtime && steps_ % realtime_periods == 0)
      send(client, realtime_message(controller_));
    const bool reads = client.queued.size() < kMostQueued;
    for (; reads && !client.held.empty() && client.held.front().due <= steps_; client.held.pop_front()) {
      const std::vector<std::uint8_t>& bytes = client.held.front().bytes;
      client.queued.insert(client.queued.end(), bytes.begin(), bytes.end());
    }
  }
}

void ControllerServers::send(Client& client, const std::vector<std::uint8_t>& bytes) {
  if (client.queued.size() > kMostQueued) return;
  client.queued.insert(client.queued.end(), bytes.begin(), bytes.end());
}

void ControllerServers::flush(Client& client) {
  if (client.queued.empty()) return;
  const ssize_t size = ::send(client.fd, client.queued.data(), client.queued.size(), MSG_NOSIGNAL);
  if (size > 0) client.queued.erase(client.queued.begin(), client.queued.begin() + size);
  if (size < 0 && errno != EAGAIN && errno != EINTR) client.ended = true;
}

}  // namespace mrroc::sim::ur
