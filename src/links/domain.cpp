#include "links/domain.hpp"

#include <dds/dds.h>
#include <sys/random.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "links/dds_log.hpp"
#include "links/descriptors.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

constexpr int kLastId = 230;              // the ports of domain 231 end beyond 65535
constexpr double kSimulatedLease = 3600;  // Cyclone's longest

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
  if (!log.empty()) text += " (" + log.back() + ")";
  throw SystemError(ErrorCode::resources, text);
}

}  // namespace

std::string dds_configuration(const DomainOptions& options) {
  if (options.id < 0 || options.id > kLastId) {
    throw SystemError(ErrorCode::configuration,
                      "DDS domain " + std::to_string(options.id) + ": expected 0.." + std::to_string(kLastId));
  }
  if (!(options.lease >= 0 && options.lease <= 60)) {
    throw SystemError(ErrorCode::configuration, "lease " + std::to_string(options.lease) + " s: expected 0..60 s");
  }
  std::string interfaces;
  std::string peers;
  if (options.hosts.empty()) {
    interfaces = "<Interfaces><NetworkInterface name=\"lo\"/></Interfaces>";
  } else {
    for (const std::string& host : options.hosts) {
      check_host(host);
      peers += "<Peer Address=\"" + host + "\"/>";
    }
    // with peers named Cyclone forgets its own machine
    peers = "<Peers><Peer Address=\"127.0.0.1\"/>" + peers + "</Peers>";
  }
  const double lease = options.lease > 0 ? std::max(1.0, 2 * options.lease) : kSimulatedLease;
  return "<CycloneDDS><Domain Id=\"any\"><General>" + interfaces +
         "<AllowMulticast>false</AllowMulticast></General>"
         "<SharedMemory><Enable>false</Enable></SharedMemory>"
         // without multicast an index of its own is what lets a process be found, and its number is the last index
         "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
         "<MaxAutoParticipantIndex>60</MaxAutoParticipantIndex><LeaseDuration>" +
         std::to_string(static_cast<long>(lease * 1000)) + "ms</LeaseDuration>" + peers +
         "</Discovery>"
         // how long a writer that ends waits for readers to acknowledge: a dead peer shall not hold it for a second
         "<Internal><WriterLingerDuration>100ms</WriterLingerDuration></Internal></Domain></CycloneDDS>";
}

Domain::Domain(DomainOptions options) : options_(std::move(options)), boot_(new_boot()) {
  const std::string configuration = dds_configuration(options_);
  install_dds_log();
  const auto before = open_descriptors();
  const auto id = static_cast<dds_domainid_t>(options_.id);
  domain_ = dds_create_domain(id, configuration.c_str());
  if (domain_ < 0) refuse("creation", options_.id, domain_);
  participant_ = dds_create_participant(id, nullptr, nullptr);
  try {
    if (participant_ < 0) refuse("participant", options_.id, participant_);
    seal_descriptors(before, loopback_only());
  } catch (...) {
    dds_delete(domain_);
    throw;
  }
}

Domain::~Domain() { dds_delete(domain_); }

}  // namespace mrroc::links
