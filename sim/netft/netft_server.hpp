#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "drivers/netft/rdt.hpp"
#include "drivers/netft/socket.hpp"
#include "mrroc/types.hpp"

namespace mrroc::sim {

/// Settings of a simulated Net F/T.
struct NetftSettings {
  std::string address = "127.0.0.1";     ///< on which it is reached
  std::uint16_t port = netft::kRdtPort;  ///< UDP; 0: a free one
  std::uint16_t http_port = 80;          ///< TCP; 0: a free one
  double rate = netft::kMaxRate;         ///< records per second of a stream, at most kMaxRate, Hz
  std::uint32_t buffer = 10;             ///< records in a packet of the buffered mode, 1 to kMaxRecords
  bool one_client = false;               ///< as the real one: a new stream ends that of another client
  double counts_per_force = 1'000'000;   ///< counts in one force_unit
  double counts_per_torque = 1'000'000;  ///< counts in one torque_unit
  std::string force_unit = "N";          ///< as netft::newtons
  std::string torque_unit = "Nm";        ///< as netft::newton_metres
  double force_range = 1e3;              ///< N: beyond it on any axis it reports saturation
  double torque_range = 1e2;             ///< N m
  std::string page;                      ///< configuration page in place of its own; empty: its own
  /// Its time, ns; empty: CLOCK_MONOTONIC. While it stands still, each request of a record is answered at once.
  std::function<std::int64_t()> now;
};

/// Faults of a simulated Net F/T and of the network to its clients; probabilities per packet.
struct NetftFaults {
  bool silent = false;       ///< it sends no records
  bool deaf = false;         ///< it ignores requests
  double loss = 0;           ///< a packet does not arrive
  double doubled = 0;        ///< a packet arrives twice
  double reordered = 0;      ///< a packet arrives after its successor
  double garbage = 0;        ///< random bytes, not of a packet's size, arrive before it
  bool frozen = false;       ///< records repeat the last measurement
  std::uint32_t status = 0;  ///< added to the status word of every record
};

/// The load on the tool's side, N and N m in the sensor frame, at a time in s since the server's start. Called in the
/// server's thread.
using NetftLoad = std::function<Wrench(double)>;

/// A simulated ATI Net F/T: an RDT server over UDP, and the configuration page netftapi2.xml over HTTP. Realtime and
/// buffered streams with or without end for up to kMaxClients clients, software bias, latch of the monitor conditions.
/// Its own thread serves both, from construction to destruction. It has no multi-unit identifiers, no monitor
/// conditions of its own and none of the other pages.
class NetftServer {
 public:
  static constexpr std::size_t kMaxClients = 8;

  /// Throws std::system_error when an address is in use or not this machine's, std::invalid_argument for settings that
  /// are impossible.
  NetftServer(const NetftSettings& settings, NetftLoad load);
  ~NetftServer();
  NetftServer(const NetftServer&) = delete;
  NetftServer& operator=(const NetftServer&) = delete;

  std::uint16_t port() const noexcept { return port_; }
  std::uint16_t http_port() const noexcept { return http_port_; }

  // any thread
  void set_load(NetftLoad load);
  void set_faults(const NetftFaults& faults);
  /// Power off and on: all streams end, the bias is lost, measurements are counted from 0.
  void restart();
  std::uint64_t requests() const;  ///< of RDT, since the server's start
  std::size_t clients() const;     ///< that have a stream

 private:
  static constexpr std::size_t kMaxConnections = 8;  ///< of HTTP
  struct Client {
    sockaddr_in address{};
    netft::Command mode = netft::Command::start_realtime;
    std::uint32_t remaining = 0;  ///< records; 0: without end
    std::uint32_t sequence = 0;
    std::vector<std::uint8_t> packet;  ///< buffered records
    std::vector<std::uint8_t> held;    ///< a packet that its successor overtakes
  };
  struct Connection {
    netft::Descriptor socket;
    std::string request;
    std::int64_t deadline = 0;
  };

  std::int64_t now() const;
  void serve();
  void wait();
  void take_requests();
  void obey(const netft::Request& request, const sockaddr_in& from);
  void answer(const sockaddr_in& from);
  void measure(std::int64_t now);
  netft::Record record(std::int64_t now);
  void add(Client& client, netft::Record record);
  void deliver(Client& client, const std::vector<std::uint8_t>& packet);
  void transmit(const Client& client, const std::vector<std::uint8_t>& packet);
  bool happens(double probability);
  void serve_http();
  bool answer(Connection& connection, std::int64_t now);
  std::string page() const;

  NetftSettings settings_;
  double counts_per_newton_;
  double counts_per_newton_metre_;
  netft::Descriptor udp_, listener_, end_;
  std::uint16_t port_ = 0, http_port_ = 0;

  mutable std::mutex mutex_;  ///< of everything below
  NetftLoad load_;
  NetftFaults faults_;
  std::vector<Client> clients_;
  std::uint64_t requests_ = 0;
  std::int64_t begin_ns_ = 0;    ///< of the server
  std::int64_t powered_ns_ = 0;  ///< of the present count of measurements
  std::uint64_t samples_ = 0;    ///< due since then
  std::array<std::int64_t, 6> bias_{};
  netft::Record newest_;
  std::mt19937_64 random_;
  std::vector<Connection> connections_;
  std::thread thread_;
};

}  // namespace mrroc::sim
