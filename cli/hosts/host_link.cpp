#include "cli/hosts/host_link.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "clock/wall/monotonic.hpp"
#include "clock/wall/realtime.hpp"

namespace mrroc::cli {

namespace {

constexpr int kBeatsInTimeout = 10;
constexpr std::int64_t kPeriodToLearn = clock::kSecond / 250;  // the peer's clock is known after 128 beats
constexpr int kPriority = 85;  // above the servo threads: a late beat would stop them all
constexpr int kFirstPort = 7600;
constexpr int kPortsOfDomain = 250;
constexpr int kPorts = 50;

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error("link between hosts: " + what + ": " + std::strerror(errno));
}

/// Follows the presses and resets of the runner's emergency stop; nothing else presses it on this host.
void follow(clock::EmergencyStop& own, const Heartbeat& beat) noexcept {
  // presses first: a reset counts for the presses before it
  while (own.presses() < beat.presses) own.press();
  while (own.resets() < beat.resets) own.reset();
}

}  // namespace

HostLink::HostLink(in_addr own, int domain, const HeartbeatKey& key, bool is_runner, double timeout,
                   clock::EmergencyStop& emergency_stop)
    : key_(key),
      is_runner_(is_runner),
      timeout_(static_cast<std::int64_t>(timeout * 1e9)),
      emergency_stop_(emergency_stop) {
  socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket_ < 0) refuse("no socket");
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr = own;
  const int first = kFirstPort + kPortsOfDomain * domain;
  for (port_ = first; port_ < first + kPorts; ++port_) {
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) break;
  }
  event_ = port_ < first + kPorts ? eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK) : -1;
  if (event_ >= 0) return;
  close(socket_);
  refuse("no free port from " + std::to_string(first) + " on");
}

HostLink::~HostLink() {
  ended_ = true;
  if (thread_.joinable()) thread_.join();
  close(socket_);
  close(event_);
}

void HostLink::start(in_addr peer, int port) {
  peer_.sin_family = AF_INET;
  peer_.sin_addr = peer;
  peer_.sin_port = htons(static_cast<std::uint16_t>(port));
  thread_ = std::thread([this] { run(); });
}

void HostLink::watch() {
  const std::lock_guard lock(mutex_);
  watched_since_ = clock::monotonic_ns();
  clock_.keep();
}

void HostLink::run() {
  {
    const std::string warning = clock::request_realtime(kPriority);
    const std::lock_guard lock(mutex_);
    warning_ = warning;
  }
  // at most one tick, so that the destructor does not wait longer
  const std::int64_t period = std::min(timeout_ / kBeatsInTimeout, clock::kSecond / 20);
  std::int64_t due = clock::monotonic_ns();
  while (!ended_) {
    const timespec pause = clock::to_timespec(std::max<std::int64_t>(due - clock::monotonic_ns(), 0));
    pollfd descriptor{socket_, POLLIN, 0};
    ppoll(&descriptor, 1, &pause, nullptr);
    const std::lock_guard lock(mutex_);
    // first read what has arrived: this machine may have been slow
    listen();
    const std::int64_t now = clock::monotonic_ns();
    check_silence(now);
    if (now < due) continue;
    send(now);
    const bool learns = watched_since_ == 0;
    due = std::max(due + (learns ? std::min(period, kPeriodToLearn) : period), now);
  }
}

void HostLink::listen() {
  std::uint8_t datagram[256];
  sockaddr_in from{};
  socklen_t size = sizeof from;
  // a limited number at once: a flood must not keep it from detecting silence
  for (int i = 0; i < 64; ++i) {
    const ssize_t length = recvfrom(socket_, datagram, sizeof datagram, 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (length < 0 && errno == ECONNREFUSED) continue;  // the peer has no socket yet
    if (length < 0) return;
    const auto beat = open(datagram, static_cast<std::size_t>(length), key_);
    if (beat && beat->from_runner != is_runner_ && beat->sequence > peer_sequence_)
      take(*beat, clock::monotonic_ns());
    else
      ++figures_.refused;
  }
}

void HostLink::take(const Heartbeat& beat, std::int64_t now) {
  ++figures_.heard;
  peer_sequence_ = beat.sequence;
  peer_sent_ = beat.sent;
  if (!is_runner_) follow(emergency_stop_, beat);
  peer_presses_ = beat.presses;
  peer_resets_ = beat.resets;
  if (beat.echo != 0) clock_.add({beat.echo, now, beat.sent, beat.held});
  if (watched_since_ != 0)
    figures_.longest_silence = std::max(figures_.longest_silence, now - std::max(heard_at_, watched_since_));
  heard_at_ = now;
}

void HostLink::send(std::int64_t now) {
  const std::uint32_t resets = emergency_stop_.resets();  // first, so that its press is sent, too
  const Heartbeat beat{
      is_runner_, ++figures_.sent, now, peer_sent_, peer_sent_ == 0 ? 0 : now - heard_at_, emergency_stop_.presses(),
      resets};
  const auto datagram = seal(beat, key_);
  // a beat that cannot be sent is a lost beat, which the peer detects
  sendto(socket_, datagram.data(), datagram.size(), 0, reinterpret_cast<const sockaddr*>(&peer_), sizeof peer_);
}

void HostLink::check_silence(std::int64_t now) {
  if (watched_since_ == 0 || lost_) return;
  const std::int64_t silence = now - std::max(heard_at_, watched_since_);
  figures_.longest_silence = std::max(figures_.longest_silence, silence);
  if (silence < timeout_) return;
  lost_ = true;
  const std::uint64_t one = 1;
  if (write(event_, &one, sizeof one) < 0) return;  // the next check sees it anyway
}

std::optional<clock::ClockOffset> HostLink::offset() const {
  const std::lock_guard lock(mutex_);
  return clock_.offset();
}

LinkFigures HostLink::figures() const {
  const std::lock_guard lock(mutex_);
  LinkFigures figures = figures_;
  figures.drift_ns = clock_.worst_drift_ns();
  figures.certain_drift_ns = clock_.certain_drift_ns();
  return figures;
}

std::string HostLink::warning() const {
  const std::lock_guard lock(mutex_);
  return warning_;
}

}  // namespace mrroc::cli
