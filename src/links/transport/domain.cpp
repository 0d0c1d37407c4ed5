#include "links/transport/domain.hpp"

#include <dds/dds.h>
#include <sys/random.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <memory>

#include "links/cyclone/received_samples.hpp"
#include "links/cyclone/received_types.hpp"
#include "links/cyclone/socket_limit.hpp"
#include "links/transport/dds_log.hpp"
#include "links/transport/descriptors.hpp"
#include "links/transport/security.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

constexpr int kLastId = 230;              // the ports of domain 231 end beyond 65535
constexpr int kLastIndex = 60;            // of a process; each has its own two ports
constexpr double kSimulatedLease = 3600;  // Cyclone's longest

/// Messages lost on a cable are requested again within a few ms; Cyclone's default of 100 ms would stop the robots each
/// time.
constexpr const char* kRepairOverCables =
    "<NackDelay>1ms</NackDelay><PreEmptiveAckDelay>1ms</PreEmptiveAckDelay>"
    "<HeartbeatInterval min=\"2ms\" minsched=\"5ms\" max=\"1s\">5ms</HeartbeatInterval>";

std::uint64_t new_boot() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string machine;
  std::getline(file, machine);
  std::uint32_t process = 0;
  while (process == 0) {
    if (::getrandom(&process, sizeof process, 0) < 0) throw SystemError(ErrorCode::resources, "no random number");
  }
  return std::uint64_t{std::hash<std::string>{}(machine)} << 32 | process;
}

void check_host(const std::string& host) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-' ||
           c == ':' || c == '_';
  };
  if (host.empty() || !std::all_of(host.begin(), host.end(), allowed)) {
    throw SystemError(ErrorCode::configuration, "host '" + host + "': expected a host name or an address");
  }
}

[[noreturn]] void refuse(const std::string& what, int id, dds_return_t code) {
  std::string text = what + " of DDS domain " + std::to_string(id) + ": " + dds_strretcode(code);
  const auto log = dds_log_messages();
  if (!log.empty() && log.back().find("free participant index") != std::string::npos) {
    const int first = 7400 + 250 * id + 10;  // OMG DDSI-RTPS 2.3, 9.6.1.1
    text = "DDS domain " + std::to_string(id) + ": no free port from " + std::to_string(first) + " to " +
           std::to_string(first + 2 * kLastIndex + 1) + ", expected two for each process; the key deployment.domain " +
           "names another domain";
  } else if (!log.empty()) {
    text += " (" + log.back() + ")";
  }
  throw SystemError(ErrorCode::resources, text);
}

}  // namespace

std::string dds_configuration(const DomainOptions& options, const NetworkInterface& interface) {
  if (options.id < 0 || options.id > kLastId) {
    throw SystemError(ErrorCode::configuration,
                      "DDS domain " + std::to_string(options.id) + ": expected 0.." + std::to_string(kLastId));
  }
  if (!(options.lease >= 0 && options.lease <= 60)) {
    throw SystemError(ErrorCode::configuration, "lease " + std::to_string(options.lease) + " s: expected 0..60 s");
  }
  if (!options.hosts.empty() && options.interface.empty()) {
    throw SystemError(ErrorCode::configuration, "hosts are named, but no network interface to reach them by");
  }
  // Cyclone's default is not sufficient: it adds its own address only to an interface without the flag MULTICAST, and
  // only when no peer is given
  std::string peers = "<Peer Address=\"" + interface.address + "\"/>";
  for (const std::string& host : options.hosts) {
    check_host(host);
    if (host != interface.address) peers += "<Peer Address=\"" + host + "\"/>";
  }
  const double lease = options.lease > 0 ? std::max(1.0, 2 * options.lease) : kSimulatedLease;
  return "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface address=\"" + interface.address +
         "\" multicast=\"false\"/></Interfaces><AllowMulticast>false</AllowMulticast></General>"
         "<SharedMemory><Enable>false</Enable></SharedMemory>"
         // without multicast a process is found by its own index, and its number is the last index
         "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
         "<MaxAutoParticipantIndex>" +
         std::to_string(kLastIndex) + "</MaxAutoParticipantIndex><LeaseDuration>" +
         std::to_string(static_cast<long>(lease * 1000)) + "ms</LeaseDuration><Peers>" + peers +
         "</Peers></Discovery>"
         // maximum time for which an ending writer waits for acknowledgements: a dead peer must not block it for a
         // second
         "<Internal><WriterLingerDuration>100ms</WriterLingerDuration>" +
         (options.hosts.empty() ? "" : kRepairOverCables) + "</Internal></Domain></CycloneDDS>";
}

Domain::Domain(DomainOptions options)
    : options_(std::move(options)), interface_(find_interface(options_.interface)), boot_(new_boot()) {
  const std::string configuration = dds_configuration(options_, interface_);
  install_dds_log();
  mend_received_samples();
  mend_received_types();
  const auto before = open_descriptors();
  const SocketLimit limit(interface_);
  domain_ = dds_create_domain(static_cast<dds_domainid_t>(options_.id), configuration.c_str());
  if (domain_ < 0) refuse("creation", options_.id, domain_);
  try {
    // before any process discovers this one
    seal_descriptors(before);
    create_participant();
    seal_descriptors(before);
  } catch (...) {
    dds_delete(domain_);
    throw;
  }
}

void Domain::create_participant() {
  const std::unique_ptr<dds_qos_t, decltype(&dds_delete_qos)> qos(dds_create_qos(), &dds_delete_qos);
  if (secured()) {
    for (const auto& [name, value] : security_properties(options_.keys)) {
      dds_qset_prop(qos.get(), name.c_str(), value.c_str());
    }
  }
  participant_ = dds_create_participant(static_cast<dds_domainid_t>(options_.id), qos.get(), nullptr);
  if (participant_ < 0) refuse("participant", options_.id, participant_);
}

Domain::~Domain() { dds_delete(domain_); }

}  // namespace mrroc::links
