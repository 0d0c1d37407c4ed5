#include "drivers/ur/rtde_link.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <system_error>

#include "clock/wall/sliced_wait.hpp"
#include "clock/wall/wait.hpp"
#include "drivers/ur/lockstep.hpp"
#include "drivers/ur/terminals.hpp"

namespace mrroc::ur {
namespace {

constexpr int kWaitMs = 50;  // between two checks for a silent controller
constexpr std::int64_t kBetweenAttempts = clock::kSecond / 5;

void signal(int eventfd) noexcept {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(eventfd, &one, sizeof one);
}

void clear(int eventfd) noexcept {
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t read = ::read(eventfd, &count, sizeof count);
}

std::int64_t after(double seconds) { return clock::monotonic_ns() + std::llround(seconds * 1e9); }

}  // namespace

RtdeLink::RtdeLink(const UrOptions& options, double servo_period)
    : options_(options),
      servo_period_(servo_period),
      connection_({options.address, options.rtde_port, options.frequency, options.timeout, servo_period}) {
  for (int* const each : {&wake_, &received_})
    if ((*each = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) < 0)
      throw std::system_error(errno, std::generic_category(), "eventfd");
}

RtdeLink::~RtdeLink() {
  end_.store(true, std::memory_order_release);
  signal(wake_);
  if (thread_.joinable()) thread_.join();
  ::close(wake_);
  ::close(received_);
}

void RtdeLink::open() {
  if (thread_.joinable()) return;  // it is open
  connect_in_time();
  const std::int64_t deadline = after(options_.timeout);
  while (packages_.load(std::memory_order_relaxed) == 0 && !options_.lockstep) {
    if (!connection_.wait_readable(deadline)) throw ConnectionError(connection_.name() + ": no data package");
    receive();
    if (!connection_.is_open()) throw ConnectionError(connection_.reason());
  }
  thread_ = std::thread([this] { run(); });
}

void RtdeLink::connect_in_time() {
  const std::int64_t deadline = after(options_.open_timeout);
  for (;;) {
    try {
      return connect();
    } catch (const ConnectionError&) {
      if (clock::monotonic_ns() >= deadline) throw;
    }
    clock::pause(kBetweenAttempts);
  }
}

/// Negotiates; on return packages arrive.
void RtdeLink::connect() {
  try {
    connection_.open(state_fields(options_.registers));
    set_points_ = connection_.set_up_inputs(set_point_fields(options_.registers));
    terminals_ = connection_.set_up_inputs(terminal_fields(options_.tool_terminals));
    if (options_.speed_slider != 0) slider_ = connection_.set_up_inputs(slider_fields());
    connection_.start();
  } catch (const ConnectionError& error) {
    lose(error.what());
    throw;
  }
  frequency_.store(connection_.frequency(), std::memory_order_relaxed);
  const double own = options_.lockstep ? 1 / servo_period_ : connection_.own_frequency();
  program_frequency_.store(own, std::memory_order_relaxed);
  clock_.start(1 / frequency());
  last_received_ = clock::monotonic_ns();
  outputs_.reset();
  if (options_.speed_slider != 0) {
    write_slider(options_.speed_slider, slider_.values);
    connection_.put(slider_);
  }
  connections_.fetch_add(1, std::memory_order_relaxed);
  up_.store(true, std::memory_order_release);
}

void RtdeLink::lose(const std::string& reason) noexcept {
  connection_.close(reason);
  report(reason);
  up_.store(false, std::memory_order_release);
  if (options_.lockstep) signal(received_);  // the servo waits without end of its own
}

void RtdeLink::report(const std::string& reason) noexcept {
  problem_for_servo_.store(edp::DriverText(reason));
  problem_for_start_.store(edp::DriverText(reason));
}

void RtdeLink::run() noexcept {
  while (!end_.load(std::memory_order_acquire)) {
    if (!connection_.is_open() && !options_.lockstep) reconnect();
    poll();
    if (!connection_.is_open()) continue;
    transmit();
    receive();
    if (options_.lockstep) continue;
    if (connection_.is_open() && clock::monotonic_ns() - last_received_ > std::llround(options_.timeout * 1e9))
      lose(connection_.name() + ": no data package");
  }
  transmit();  // the servo's last command switches the drives off
  connection_.pause();
}

void RtdeLink::reconnect() noexcept {
  try {
    connect();
  } catch (const std::exception& error) {
    report(error.what());
  }
}

/// Until the socket or the servo thread has something, or a while has passed.
void RtdeLink::poll() noexcept {
  std::array<pollfd, 2> entries{{{wake_, POLLIN, 0}, {connection_.fd(), POLLIN, 0}}};
  if (connection_.has_unsent()) entries[1].events |= POLLOUT;
  if (connection_.is_open()) {
    ::poll(entries.data(), entries.size(), kWaitMs);
  } else {
    // the servo thread continues to hand set-points over: they must not make the attempts more frequent
    clock::pause(kBetweenAttempts);
  }
  clear(wake_);
}

bool RtdeLink::wait(std::int64_t deadline) noexcept {
  if (!clock::wait_for(received_, POLLIN, deadline)) return false;
  clear(received_);
  return true;
}

const RobotState* RtdeLink::await(Tick tick) noexcept {
  const Tick due = tick - tick % package_ticks(frequency(), servo_period_);
  for (;;) {
    const RobotState* const state = newest();
    if (state != nullptr && tick_of_package(state->timestamp, servo_period_) >= due) return state;
    const auto wait_until = [this](std::int64_t deadline) { return wait(deadline); };
    if (!is_up() || !clock::wait_in_slices(kLockstepTimeout, wait_until)) return nullptr;
  }
}

void RtdeLink::receive() noexcept {
  const std::uint64_t before = packages_.load(std::memory_order_relaxed);
  while (const std::vector<rtde::Value>* const values = connection_.next())
    if (!take(*values)) return lose(connection_.name() + ": a data package is not of the agreed recipe");
  if (!connection_.is_open() && is_up()) lose(connection_.reason());
  const std::uint64_t taken = packages_.load(std::memory_order_relaxed) - before;
  if (taken == 0) return;
  bunched_.fetch_add(taken - 1, std::memory_order_relaxed);
  signal(received_);
}

bool RtdeLink::take(const std::vector<rtde::Value>& values) noexcept {
  if (!read_state(values, state_)) return false;
  last_received_ = state_.received = clock::monotonic_ns();
  state_.number = packages_.fetch_add(1, std::memory_order_relaxed) + 1;
  const clock::PackageClock::Verdict verdict = clock_.take(state_.timestamp, state_.received);
  lost_.fetch_add(verdict.lost, std::memory_order_relaxed);
  late_.fetch_add(verdict.late, std::memory_order_relaxed);
  doubled_.fetch_add(verdict.doubled, std::memory_order_relaxed);
  for_servo_.store(state_);
  for_start_.store(state_);
  return true;
}

void RtdeLink::send(const Command& command) noexcept {
  commands_.store(command);
  signal(wake_);
}

void RtdeLink::transmit() noexcept {
  if (!connection_.is_open()) return;
  connection_.flush();
  const Command* const command = commands_.load();
  // a socket that takes nothing gets the newest set-points when it takes bytes again, not all of the missed ones
  if (command == nullptr || command->sequence == last_sequence_ || connection_.has_unsent()) return;
  if (command->sets_outputs && outputs_ != command->outputs) {
    write_terminals(command->outputs, options_.tool_terminals, terminals_.values);
    connection_.put(terminals_);
    outputs_ = command->outputs;
  }
  const auto step = static_cast<std::uint32_t>(command->sequence) - static_cast<std::uint32_t>(last_sequence_);
  if (started_sending_) unsent_.fetch_add(step - 1, std::memory_order_relaxed);
  started_sending_ = true;
  last_sequence_ = command->sequence;
  write_set_points(*command, set_points_.values);
  connection_.put(set_points_);
  sent_.fetch_add(1, std::memory_order_relaxed);
  connection_.flush();
}

LinkCounters RtdeLink::counters() const noexcept {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  return {{packages_.load(kRelaxed), lost_.load(kRelaxed), doubled_.load(kRelaxed), late_.load(kRelaxed),
           bunched_.load(kRelaxed)},
          sent_.load(kRelaxed),
          unsent_.load(kRelaxed),
          connections_.load(kRelaxed)};
}

}  // namespace mrroc::ur
