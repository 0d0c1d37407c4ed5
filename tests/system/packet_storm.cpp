#include "system/packet_storm.hpp"

#include <arpa/inet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <netinet/ip.h>
#include <netinet/udp.h>
#include <netpacket/packet.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <stdexcept>

namespace mrroc::test {

namespace {

constexpr int kParticipants = 10;  // more than in the deployments of the tests
constexpr std::size_t kMemory = 2000;
constexpr int kStrangers = 4;  // for each participant
constexpr int kBurst = 16;     // datagrams per millisecond
constexpr auto kPause = std::chrono::milliseconds(1);
constexpr int kNiceness = 10;

int first_port(int domain) { return 7400 + 250 * domain; }

/// A socket that receives a copy of what passes the loopback device.
int open_ear() {
  const int ear = ::socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, htons(ETH_P_IP));
  sockaddr_ll address{};
  address.sll_family = AF_PACKET;
  address.sll_protocol = htons(ETH_P_IP);
  address.sll_ifindex = static_cast<int>(::if_nametoindex("lo"));
  if (::bind(ear, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return ear;
  throw std::runtime_error("no packet socket for a packet storm");
}

}  // namespace

PacketStorm::PacketStorm(int domain, std::uint32_t seed)
    : domain_(domain), random_(seed), ear_(open_ear()), mouth_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
  if (mouth_ < 0) throw std::runtime_error("no socket for a packet storm");
  // its own port distinguishes its own datagrams from the captured ones
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::bind(mouth_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::runtime_error("no port for a packet storm");
  }
  thread_ = std::thread([this] { blow(); });
}

PacketStorm::~PacketStorm() {
  over_ = true;
  thread_.join();
  ::close(ear_);
  ::close(mouth_);
}

void PacketStorm::blow() {
  // forged datagrams are what is tested, not processes that a flood has left without processor time
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNiceness);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  while (!over_) {
    listen();
    for (int i = 0; i < kBurst; ++i) {
      const std::string packet = datagram();
      const auto port = first_port(domain_) + 10 + static_cast<int>(random_() % (2 * kParticipants));
      address.sin_port = htons(static_cast<in_port_t>(port));
      // a port without a listener refuses it, which does not matter
      if (::sendto(mouth_, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&address),
                   sizeof address) >= 0) {
        ++sent_;
      }
    }
    std::this_thread::sleep_for(kPause);
  }
}

void PacketStorm::listen() {
  sockaddr_in own{};
  socklen_t size = sizeof own;
  ::getsockname(mouth_, reinterpret_cast<sockaddr*>(&own), &size);
  std::array<char, 65536> buffer;
  for (int looks = 0; looks < 200; ++looks) {
    const ssize_t got = ::recv(ear_, buffer.data(), buffer.size(), 0);
    if (got < 0) return;
    iphdr ip{};
    udphdr udp{};
    const auto length = static_cast<std::size_t>(got);
    if (length < sizeof ip) continue;
    std::memcpy(&ip, buffer.data(), sizeof ip);
    const std::size_t head = ip.ihl * 4U;
    if (ip.protocol != IPPROTO_UDP || length < head + sizeof udp) continue;
    std::memcpy(&udp, buffer.data() + head, sizeof udp);
    const int port = ntohs(udp.uh_dport);
    const bool of_domain = port >= first_port(domain_) && port < first_port(domain_ + 1);
    if (!of_domain || udp.uh_sport == own.sin_port) continue;
    heard_.emplace_back(buffer.data() + head + sizeof udp, length - head - sizeof udp);
    ++overheard_;
    if (heard_.size() > kMemory) heard_.pop_front();
  }
}

std::string PacketStorm::random_bytes(std::size_t most) {
  std::string bytes(random_() % (most + 1), '\0');
  for (char& byte : bytes) byte = static_cast<char>(random_());
  return bytes;
}

std::string PacketStorm::mutated(std::string packet) {
  for (std::size_t changes = 1 + random_() % 8; changes > 0 && !packet.empty(); --changes) {
    // mostly behind the header with its live sender: a datagram with a wrong header is dropped at once
    const std::size_t from = random_() % 10 != 0 && packet.size() > 20 ? 20 : 0;
    packet[from + random_() % (packet.size() - from)] = static_cast<char>(random_());
  }
  return packet;
}

std::string PacketStorm::of_stranger(std::string packet) {
  constexpr std::size_t kHeader = 8, kPrefix = 12;
  if (packet.size() < kHeader + kPrefix) return packet;
  const std::string sender = packet.substr(kHeader, kPrefix);
  std::string unknown = sender;
  unknown.back() = static_cast<char>(random_() % kStrangers);
  for (auto at = packet.find(sender); at != std::string::npos; at = packet.find(sender, at + kPrefix))
    packet.replace(at, kPrefix, unknown);
  return packet;
}

std::string PacketStorm::datagram() {
  const auto kind = random_() % 100;
  if (kind < 5) return random_bytes(1500);
  if (kind < 25 || heard_.empty()) {
    // a header, one of the known submessages, and random bytes
    std::string packet("RTPS\x02\x01\x01\x10", 8);
    for (int i = 0; i < 12; ++i) packet.push_back(static_cast<char>(random_()));
    packet.push_back(static_cast<char>(random_() % 0x36));
    return packet + random_bytes(200);
  }
  std::string packet = heard_[random_() % heard_.size()];
  if (random_() % 2 == 0) packet = of_stranger(std::move(packet));
  if (kind < 75) return mutated(std::move(packet));
  if (kind < 90) packet.resize(random_() % (packet.size() + 1));
  return packet;
}

}  // namespace mrroc::test
