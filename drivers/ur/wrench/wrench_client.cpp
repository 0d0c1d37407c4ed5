#include "drivers/ur/wrench/wrench_client.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <system_error>

#include "clock/wall/sliced_wait.hpp"
#include "clock/wall/wait.hpp"
#include "drivers/ur/lockstep.hpp"

namespace mrroc::ur {
namespace {

constexpr std::int64_t kBetweenAttempts = clock::kSecond / 5;
constexpr int kMsBetweenAttempts = 200;
constexpr double kAnswerTime = 1;  // s

std::int64_t after(double seconds) { return clock::monotonic_ns() + std::llround(seconds * 1e9); }

}  // namespace

std::string disturbances(const WrenchCounters& counters) {
  const std::uint64_t reconnections = counters.connections > 0 ? counters.connections - 1 : 0;
  std::string text;
  for (const auto& [count, what] :
       {std::pair{counters.lost, " lost"}, std::pair{counters.late, " late"}, std::pair{counters.doubled, " doubled"},
        std::pair{counters.restarts, " restarts of the controller"}, std::pair{reconnections, " reconnections"}})
    if (count > 0) text.append(text.empty() ? " " : ", ").append(std::to_string(count)).append(what);
  return text.empty() ? text : "of " + std::to_string(counters.packages) + " packages" + text;
}

WrenchClient::WrenchClient(const WrenchOptions& options)
    : options_(options),
      connection_({options.address, options.port, options.frequency, std::min(options.start_timeout, kAnswerTime)}) {
  await_first();
  end_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (end_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  thread_ = std::thread([this] { serve(); });
}

WrenchClient::~WrenchClient() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(end_, &one, sizeof one);
  if (thread_.joinable()) thread_.join();
  ::close(end_);
}

WrenchCounters WrenchClient::counters() const noexcept {
  WrenchCounters counters;
  counters_.load(counters);
  return counters;
}

void WrenchClient::connect() {
  connection_.open(wrench_fields());
  connection_.start();
  clock_.start(1 / connection_.frequency());
  ++counted_.connections;
  newest_.point = rtde::is_e_series(connection_.version()) ? TorquePoint::flange : TorquePoint::tool;
  newest_.arrival_ns = clock::monotonic_ns();  // of the connection, until a package comes
}

/// A controller that is still starting refuses the connection: tries again until `start_timeout`.
void WrenchClient::await_first() {
  const std::int64_t deadline = after(options_.start_timeout);
  for (;;) {
    try {
      connect();
      break;
    } catch (const ConnectionError&) {
      if (clock::monotonic_ns() >= deadline) throw;
    }
    clock::pause(kBetweenAttempts);
  }
  while (counted_.packages == 0 && !options_.lockstep) {
    if (!connection_.wait_readable(deadline)) throw ConnectionError(connection_.name() + ": no data package");
    receive();
    if (!connection_.is_open()) throw ConnectionError(connection_.reason());
  }
}

void WrenchClient::serve() noexcept {
  if (options_.lockstep) return serve_lockstep();
  const std::int64_t timeout = std::llround(options_.timeout * 1e9);
  while (!is_ending(connection_.is_open() ? static_cast<int>(timeout / 1'000'000) : kMsBetweenAttempts)) {
    if (connection_.is_open()) {
      receive();
      if (clock::monotonic_ns() - newest_.arrival_ns > timeout) connection_.close("no data package");
      continue;
    }
    try {
      connect();
    } catch (const std::exception&) {  // another attempt follows; until then the sensor is silent
    }
  }
  connection_.pause();
}

void WrenchClient::serve_lockstep() noexcept {
  while (connection_.is_open() && !is_ending(-1)) {
    receive();
    lost_.store(!connection_.is_open());
    received_.open();
  }
  connection_.pause();
}

const MeasuredWrench* WrenchClient::await(Tick tick, double period) noexcept {
  const Tick due = tick - tick % package_ticks(connection_.frequency(), period);
  const MeasuredWrench* newest = nullptr;
  const auto there = [&] {
    const bool lost = lost_.load();  // first: packages that came before the end count
    newest = handed_.load();
    if (newest != nullptr && tick_of_package(newest->package.timestamp, period) >= due) return true;
    newest = nullptr;
    return lost;
  };
  const auto wait = [&](std::int64_t deadline) { return received_.wait(there, deadline - clock::monotonic_ns()); };
  clock::wait_in_slices(kLockstepTimeout, wait);
  return newest;
}

/// Waits for bytes of the controller; true: this object ends.
bool WrenchClient::is_ending(int wait_ms) const noexcept {
  std::array<pollfd, 2> both{{{end_, POLLIN, 0}, {connection_.fd(), POLLIN, 0}}};
  ::poll(both.data(), both.size(), wait_ms);
  return both[0].revents != 0;
}

void WrenchClient::receive() noexcept {
  while (const std::vector<rtde::Value>* const values = connection_.next()) {
    const auto package = read_wrench(*values);
    if (!package) return connection_.close("a data package is not of the agreed recipe");
    take(*package);
  }
  counters_.store(counted_);
}

void WrenchClient::take(const WrenchPackage& package) noexcept {
  newest_.arrival_ns = clock::monotonic_ns();
  if (options_.lockstep) {  // wall time does not judge it
    newest_.package = package;
    return handed_.store(newest_);
  }
  const clock::PackageClock::Verdict verdict = clock_.take(package.timestamp, newest_.arrival_ns);
  ++counted_.packages;
  counted_.lost += verdict.lost;
  counted_.late += verdict.late ? 1 : 0;
  counted_.doubled += verdict.doubled ? 1 : 0;
  counted_.restarts += verdict.restarted ? 1 : 0;
  if (verdict.doubled) return;
  newest_.package = package;
  handed_.store(newest_);
}

}  // namespace mrroc::ur
