#include "sim/ur/controller_servers.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <system_error>

#include "sim/ur/controller_client.hpp"
#include "sim/ur/tcp_listener.hpp"

namespace mrroc::sim::ur {

namespace {

constexpr std::size_t kLongestProgram = 1 << 20;

[[noreturn]] void fail(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

}  // namespace

struct ControllerServers::Listener {
  Service service;
  int fd;
};

ControllerServers::ControllerServers(const Options& options, std::unique_ptr<JointPlant> plant)
    : options_(options), controller_(options.controller, std::move(plant)) {
  try {
    for (const auto& [service, port, taken] :
         {std::tuple{Service::rtde, options.rtde_port, &ports_.rtde},
          std::tuple{Service::dashboard, options.dashboard_port, &ports_.dashboard},
          std::tuple{Service::primary, options.primary_port, &ports_.primary},
          std::tuple{Service::secondary, options.secondary_port, &ports_.secondary},
          std::tuple{Service::realtime, options.realtime_port, &ports_.realtime}}) {
      const auto [fd, bound] = open_listener(options.address, port);
      listeners_.push_back({service, fd});
      *taken = bound;
    }
    wake_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    timer_ = ::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK);
    if (wake_ < 0 || timer_ < 0) fail("eventfd or timerfd");
  } catch (...) {
    for (const Listener& listener : listeners_) ::close(listener.fd);
    throw;
  }
  const auto ns = options.lockstep_register ? 0 : std::lround(options.controller.period / options.clock_rate * 1e9);
  const itimerspec interval{{0, ns}, {0, ns}};  // 0: it never expires
  ::timerfd_settime(timer_, 0, &interval, nullptr);
  thread_ = std::thread([this] { run(); });
}

ControllerServers::~ControllerServers() {
  end_.store(true);
  wake();
  thread_.join();
  for (const Client& client : clients_) ::close(client.fd);
  for (const Listener& listener : listeners_) ::close(listener.fd);
  ::close(wake_);
  ::close(timer_);
}

/// Lets the thread look at the clients.
void ControllerServers::wake() const noexcept {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(wake_, &one, sizeof one);
}

std::uint64_t ControllerServers::periods() {
  const std::lock_guard lock(mutex_);
  return steps_;
}

std::size_t ControllerServers::rtde_clients() {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(clients_.begin(), clients_.end(), [](const Client& client) {
    return client.service == Service::rtde && !client.ended;
  }));
}

void ControllerServers::with(const std::function<void(VirtualController&)>& action) {
  const std::lock_guard lock(mutex_);
  action(controller_);
}

void ControllerServers::cut() {
  const std::lock_guard lock(mutex_);
  end_clients(false);
}

void ControllerServers::refuse(bool on) {
  const std::lock_guard lock(mutex_);
  refuse_ = on;
  if (on) end_clients(false);
}

void ControllerServers::lose(int packages) {
  const std::lock_guard lock(mutex_);
  lose_ = packages;
}

void ControllerServers::repeat(int packages) {
  const std::lock_guard lock(mutex_);
  repeat_ = packages;
}

void ControllerServers::delay(int periods) {
  const std::lock_guard lock(mutex_);
  delay_ = periods;
}

void ControllerServers::lose_every(int n) {
  const std::lock_guard lock(mutex_);
  lose_every_ = n;
}

void ControllerServers::postpone(int periods) {
  const std::lock_guard lock(mutex_);
  postpone_ = periods;
}

void ControllerServers::send_garbage() {
  const std::lock_guard lock(mutex_);
  for (Client& client : clients_)
    if (client.service == Service::rtde)
      for (int i = 0; i < 64; ++i) client.queued.push_back(static_cast<std::uint8_t>(0xa5 ^ i));
}

void ControllerServers::restart() {
  const std::lock_guard lock(mutex_);
  end_clients(true);
  controller_.restart();
}

void ControllerServers::end_clients(bool all) {
  for (Client& client : clients_) client.ended = client.ended || all || client.service == Service::rtde;
  wake();
}

void ControllerServers::run() {
  while (!end_.load()) {
    std::vector<pollfd> entries{{wake_, POLLIN, 0}, {timer_, POLLIN, 0}};
    for (const Listener& listener : listeners_) entries.push_back({listener.fd, POLLIN, 0});
    std::vector<Client*> polled;
    {
      const std::lock_guard lock(mutex_);
      for (Client& client : clients_) {
        entries.push_back({client.fd, static_cast<short>(client.queued.empty() ? POLLIN : POLLIN | POLLOUT), 0});
        polled.push_back(&client);
      }
    }
    ::poll(entries.data(), entries.size(), -1);
    const std::lock_guard lock(mutex_);
    std::uint64_t periods = 0, wakes = 0;
    [[maybe_unused]] const ssize_t woken = ::read(wake_, &wakes, sizeof wakes);
    if (::read(timer_, &periods, sizeof periods) != sizeof periods) periods = 0;
    for (std::size_t i = 0; i < listeners_.size(); ++i)
      if (entries[2 + i].revents != 0) accept(listeners_[i]);
    for (std::size_t i = 0; i < polled.size(); ++i)
      if ((entries[2 + listeners_.size() + i].revents & (POLLIN | POLLHUP | POLLERR)) != 0) take(*polled[i]);
    for (; periods > 0; --periods) step();
    for (Client& client : clients_) flush(client);
    std::erase_if(clients_, [](const Client& client) {
      if (client.ended) ::close(client.fd);
      return client.ended;
    });
    if (options_.lockstep_register) answered_or_gone_.notify_all();
  }
}

void ControllerServers::accept(Listener& listener) {
  const int fd = ::accept4(listener.fd, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (fd < 0) return;
  if (refuse_ && listener.service == Service::rtde) {
    ::close(fd);
    return;
  }
  const int on = 1;
  ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  Client& client = clients_.emplace_back();
  client.service = listener.service;
  client.fd = fd;
  constexpr std::string_view kGreeting = "Connected: Universal Robots Dashboard Server\n";
  if (listener.service == Service::dashboard) client.queued.assign(kGreeting.begin(), kGreeting.end());
}

void ControllerServers::take(Client& client) {
  if (client.ended) return;
  for (;;) {
    std::array<std::uint8_t, 4096> bytes{};
    const bool rtde = client.service == Service::rtde;
    const std::span<std::uint8_t> space = rtde ? client.packets.free_space() : std::span<std::uint8_t>(bytes);
    const ssize_t size = ::recv(client.fd, space.data(), space.size(), 0);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (size <= 0) {
      client.ended = true;
      return;
    }
    if (rtde) {
      client.packets.filled(static_cast<std::size_t>(size));
      take_rtde(client);
    } else {
      client.text.append(reinterpret_cast<const char*>(bytes.data()), static_cast<std::size_t>(size));
      client.service == Service::dashboard ? take_lines(client) : take_programs(client);
    }
    if (client.ended) return;
  }
}

void ControllerServers::take_lines(Client& client) {
  for (std::size_t end = 0; (end = client.text.find('\n')) != std::string::npos;) {
    std::string line = client.text.substr(0, end);
    client.text.erase(0, end + 1);
    if (line.ends_with('\r')) line.pop_back();
    const std::string reply = (line == "quit" ? "Disconnected" : controller_.dashboard(line)) + "\n";
    client.queued.insert(client.queued.end(), reply.begin(), reply.end());
    if (line == "quit") client.ended = true;
  }
  if (client.text.size() > kLongestProgram) client.ended = true;
}

/// A program ends with a line "end" that is not indented. Other lines are single commands, or of no effect.
void ControllerServers::take_programs(Client& client) {
  std::string& text = client.text;
  while (!text.empty()) {
    const std::size_t line_end = text.find('\n');
    if (line_end == std::string::npos) break;
    if (!text.starts_with("def ")) {
      controller_.start_program(text.substr(0, line_end));
      text.erase(0, line_end + 1);
      continue;
    }
    const std::size_t end = text.find("\nend\n");
    if (end == std::string::npos) break;
    controller_.start_program(text.substr(0, end + 5));
    text.erase(0, end + 5);
  }
  if (text.size() > kLongestProgram) client.ended = true;
}

}  // namespace mrroc::sim::ur
