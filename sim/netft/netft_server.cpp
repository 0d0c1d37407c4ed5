#include "sim/netft/netft_server.hpp"

#include <poll.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "clock/wall/monotonic.hpp"
#include "config/text/message_text.hpp"
#include "drivers/netft/calibration.hpp"

namespace mrroc::sim {

namespace {

using netft::Command;
using netft::generic;

/// A server that wakes late sends the samples of this time, s, and skips older ones.
constexpr double kMaxBacklog = 0.1;

[[noreturn]] void fail_by_system(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), "simulated Net F/T: " + what);
}

std::uint16_t bind_to(const netft::Descriptor& socket, const std::string& address, std::uint16_t port) {
  if (!socket.valid()) fail_by_system("no socket");
  sockaddr_in place = netft::resolve(address, port);
  socklen_t size = sizeof place;
  if (::bind(socket.get(), generic(place), size) != 0 || ::getsockname(socket.get(), generic(place), &size) != 0) {
    fail_by_system(netft::place_text(address, port));
  }
  return ntohs(place.sin_port);
}

bool same(const sockaddr_in& a, const sockaddr_in& b) {
  return a.sin_addr.s_addr == b.sin_addr.s_addr && a.sin_port == b.sin_port;
}

double per_si_unit(double counts, std::optional<double> unit, const std::string& name) {
  if (!unit) throw std::invalid_argument("simulated Net F/T: unknown unit " + config::in_quotes(name));
  if (!(counts > 0)) throw std::invalid_argument("simulated Net F/T: counts per unit of at most 0");
  return counts / *unit;
}

std::int32_t to_count(double value) {
  return static_cast<std::int32_t>(std::llround(std::clamp(value, -2147483648.0, 2147483647.0)));
}

}  // namespace

NetftServer::NetftServer(const NetftSettings& settings, NetftLoad load)
    : settings_(settings),
      counts_per_newton_(
          per_si_unit(settings.counts_per_force, netft::newtons(settings.force_unit), settings.force_unit)),
      counts_per_newton_metre_(
          per_si_unit(settings.counts_per_torque, netft::newton_metres(settings.torque_unit), settings.torque_unit)),
      udp_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)),
      listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)),
      end_(::eventfd(0, EFD_CLOEXEC)),
      load_(std::move(load)) {
  if (!(settings.rate > 0 && settings.rate <= netft::kMaxRate)) {
    throw std::invalid_argument("simulated Net F/T: a rate of " + config::number_text(settings.rate) +
                                " Hz, expected at most " + config::number_text(netft::kMaxRate));
  }
  if (settings.buffer < 1 || settings.buffer > netft::kMaxRecords) {
    throw std::invalid_argument("simulated Net F/T: " + std::to_string(settings.buffer) +
                                " records in a packet, expected 1 to " + std::to_string(netft::kMaxRecords));
  }
  // connections of an earlier server may still be closing; a UDP port would be shared by two servers
  const int on = 1;
  ::setsockopt(listener_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  port_ = bind_to(udp_, settings.address, settings.port);
  http_port_ = bind_to(listener_, settings.address, settings.http_port);
  if (::listen(listener_.get(), static_cast<int>(kMaxConnections)) != 0) fail_by_system("no server");
  begin_ns_ = powered_ns_ = now();
  thread_ = std::thread([this] { serve(); });
}

NetftServer::~NetftServer() {
  const std::uint64_t one = 1;
  if (::write(end_.get(), &one, sizeof one) == sizeof one) thread_.join();
}

void NetftServer::set_load(NetftLoad load) {
  const std::lock_guard lock(mutex_);
  load_ = std::move(load);
}

void NetftServer::set_faults(const NetftFaults& faults) {
  const std::lock_guard lock(mutex_);
  faults_ = faults;
}

void NetftServer::restart() {
  const std::lock_guard lock(mutex_);
  clients_.clear();
  bias_ = {};
  powered_ns_ = now();
  samples_ = 0;
}

std::uint64_t NetftServer::requests() const {
  const std::lock_guard lock(mutex_);
  return requests_;
}

std::size_t NetftServer::clients() const {
  const std::lock_guard lock(mutex_);
  return clients_.size();
}

std::int64_t NetftServer::now() const { return settings_.now ? settings_.now() : clock::monotonic_ns(); }

void NetftServer::serve() {
  for (;;) {
    wait();
    pollfd end{end_.get(), POLLIN, 0};
    if (::poll(&end, 1, 0) > 0) return;
    const std::lock_guard lock(mutex_);
    take_requests();
    measure(now());
    serve_http();
  }
}

/// Until a packet or a connection comes or, while there are streams, a sample is due.
void NetftServer::wait() {
  std::vector<pollfd> all{{end_.get(), POLLIN, 0}, {udp_.get(), POLLIN, 0}, {listener_.get(), POLLIN, 0}};
  std::int64_t limit_ns = clock::kSecond;
  {
    const std::lock_guard lock(mutex_);
    for (const Connection& each : connections_) all.push_back({each.socket.get(), POLLIN, 0});
    if (!clients_.empty()) {
      const double due = static_cast<double>(samples_) / settings_.rate;
      limit_ns = std::clamp<std::int64_t>(powered_ns_ + netft::to_ns(due) - now(), 0, clock::kSecond);
    }
  }
  const timespec limit = clock::to_timespec(limit_ns);
  ::ppoll(all.data(), all.size(), &limit, nullptr);
}

void NetftServer::take_requests() {
  std::array<std::uint8_t, 64> packet{};
  for (;;) {
    sockaddr_in from{};
    socklen_t length = sizeof from;
    const ssize_t size = ::recvfrom(udp_.get(), packet.data(), packet.size(), 0, generic(from), &length);
    if (size < 0) return;
    const auto request = netft::decode_request(std::span(packet).first(static_cast<std::size_t>(size)));
    if (!request || faults_.deaf) continue;
    ++requests_;
    const bool one = request->command == Command::start_realtime && request->count == 1;
    if (settings_.now && one)
      answer(from);
    else
      obey(*request, from);
  }
}

/// Time stands still: the record is that of the present moment, not of the next sample.
void NetftServer::answer(const sockaddr_in& from) {
  Client client{from, Command::start_realtime, 1, 0, {}, {}};
  add(client, record(now()));
}

void NetftServer::obey(const netft::Request& request, const sockaddr_in& from) {
  if (request.command == Command::set_bias) {
    record(now());
    for (std::size_t i = 0; i < 6; ++i) bias_[i] += newest_.counts[i];
    return;
  }
  if (request.command == Command::reset_threshold) {
    faults_.status &= ~netft::kMonitorCondition;
    return;
  }
  const bool start = request.command != Command::stop;
  std::erase_if(clients_,
                [&](const Client& each) { return same(each.address, from) || (start && settings_.one_client); });
  if (!start) return;
  if (clients_.size() == kMaxClients) clients_.erase(clients_.begin());
  if (clients_.empty()) {  // the first sample is the present one
    samples_ = static_cast<std::uint64_t>(static_cast<double>(now() - powered_ns_) * 1e-9 * settings_.rate);
  }
  clients_.push_back({from, request.command, request.count, 0, {}, {}});
}

/// Takes the samples that are due, and sends them to all streams.
void NetftServer::measure(std::int64_t now) {
  const double elapsed = static_cast<double>(now - powered_ns_) * 1e-9;
  const auto due = static_cast<std::uint64_t>(elapsed * settings_.rate) + 1;
  const auto most = static_cast<std::uint64_t>(kMaxBacklog * settings_.rate) + 1;
  if (clients_.empty()) return;
  if (due > samples_ + most) samples_ = due - most;
  for (; samples_ < due && !clients_.empty(); ++samples_) {
    const netft::Record made = record(powered_ns_ + netft::to_ns(static_cast<double>(samples_) / settings_.rate));
    for (Client& client : clients_) add(client, made);
    std::erase_if(clients_, [](const Client& each) { return each.mode == Command::stop; });
  }
}

netft::Record NetftServer::record(std::int64_t now) {
  if (faults_.frozen) return newest_;
  const Wrench load = load_(static_cast<double>(now - begin_ns_) * 1e-9);
  netft::Record made;
  made.ft_sequence = netft::measurements_until(now - powered_ns_);
  made.status = faults_.status;
  if (load.head<3>().cwiseAbs().maxCoeff() > settings_.force_range ||
      load.tail<3>().cwiseAbs().maxCoeff() > settings_.torque_range) {
    made.status |= netft::kErrorSummary | netft::kSaturated;
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const double counts = load[static_cast<int>(i)] * (i < 3 ? counts_per_newton_ : counts_per_newton_metre_);
    made.counts[i] = to_count(counts - static_cast<double>(bias_[i]));
  }
  newest_ = made;
  return made;
}

void NetftServer::add(Client& client, netft::Record record) {
  record.rdt_sequence = ++client.sequence;
  const auto bytes = netft::encode(record);
  client.packet.insert(client.packet.end(), bytes.begin(), bytes.end());
  const bool last = client.remaining == 1;
  if (client.remaining > 0) --client.remaining;
  const std::size_t full = client.mode == Command::start_buffered ? settings_.buffer : 1;
  if (client.packet.size() >= full * netft::kRecordSize || last) {
    deliver(client, client.packet);
    client.packet.clear();
  }
  if (last) client.mode = Command::stop;
}

/// Sends a packet through the network with its faults.
void NetftServer::deliver(Client& client, const std::vector<std::uint8_t>& packet) {
  if (faults_.silent) return;
  if (happens(faults_.garbage)) {
    std::vector<std::uint8_t> bytes(random_() % 100);
    if (bytes.size() % netft::kRecordSize == 0) bytes.push_back(0);
    std::generate(bytes.begin(), bytes.end(), [this] { return static_cast<std::uint8_t>(random_()); });
    transmit(client, bytes);
  }
  if (happens(faults_.loss)) return;
  if (client.held.empty() && happens(faults_.reordered)) {
    client.held = packet;
    return;
  }
  transmit(client, packet);
  if (happens(faults_.doubled)) transmit(client, packet);
  if (!client.held.empty()) {
    transmit(client, client.held);
    client.held.clear();
  }
}

void NetftServer::transmit(const Client& client, const std::vector<std::uint8_t>& packet) {
  // a client that has ended refuses it, and the kernel drops it
  static_cast<void>(
      ::sendto(udp_.get(), packet.data(), packet.size(), MSG_NOSIGNAL, generic(client.address), sizeof client.address));
}

bool NetftServer::happens(double probability) {
  return probability > 0 && std::uniform_real_distribution<double>(0, 1)(random_) < probability;
}

}  // namespace mrroc::sim
