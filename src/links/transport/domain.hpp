#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "links/transport/network_interface.hpp"

namespace mrroc::links {

struct DomainOptions {
  int id = 0;  ///< DDS domain, 0..230
  /// The device, or this machine's own IPv4 address, by which the peers are reached; empty: loopback, this machine only
  std::string interface = {};
  /// Names or addresses of the machines that take part; may include this one. Only together with `interface`.
  std::vector<std::string> hosts = {};
  /// s of silence of a peer's whole process after which it counts as lost; 0: never. For simulated time, where the
  /// clock's host watches the processes and a busy machine must not count as a death.
  double lease = 0.5;
  /// Folder of the deployment's keys (security.hpp): only participants with these keys are accepted, and every message
  /// is signed; empty: every participant that reaches the interface is accepted.
  std::filesystem::path keys = {};
};

/// This process's participation in DDS, configured by the framework alone: the environment is ignored. One per process
/// and domain number. Unicast; its sockets receive only from the chosen interface, by default the loopback device; at
/// most 61 processes per machine; no shared memory; descriptors close on exec; dds_log.hpp receives Cyclone's log.
///
/// Cyclone's threads inherit the scheduling class and priority of the thread that constructs this: set them before.
/// Start children before, and open no descriptors in other threads during construction. Construct and destroy in one
/// thread; it must outlive its readers and writers.
class Domain {
 public:
  /// Throws SystemError: a bad option, interface or key folder (configuration), or an error of Cyclone (resources),
  /// with its text.
  explicit Domain(DomainOptions options);
  ~Domain();
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  int id() const noexcept { return options_.id; }
  /// Whether it cannot be reached from other machines.
  bool loopback_only() const noexcept { return interface_.loopback; }
  bool secured() const noexcept { return !options_.keys.empty(); }
  double lease() const noexcept { return options_.lease; }
  /// Number of this start of the process: random in the low half; the high half names the machine and its start-up, so
  /// that a receiver can recognise processes with the same CLOCK_MONOTONIC. Never 0.
  std::uint64_t boot() const noexcept { return boot_; }
  /// The DDS participant.
  std::int32_t participant() const noexcept { return participant_; }

 private:
  void create_participant();

  DomainOptions options_;
  NetworkInterface interface_;
  std::uint64_t boot_;
  std::int32_t domain_ = 0;
  std::int32_t participant_ = 0;
};

/// Whether both boots are of processes of one machine, so that their monotonic clocks are one.
constexpr bool same_machine(std::uint64_t boot, std::uint64_t other) noexcept { return boot >> 32 == other >> 32; }

/// The configuration for Cyclone DDS on `interface`. Throws SystemError for a bad option.
std::string dds_configuration(const DomainOptions& options, const NetworkInterface& interface);

}  // namespace mrroc::links
