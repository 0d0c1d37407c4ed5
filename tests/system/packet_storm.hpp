#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <random>
#include <string>
#include <thread>

namespace mrroc::test {

/// Floods the RTPS ports of a DDS domain of this machine with datagrams during its lifetime: random bytes, RTPS headers
/// with random contents, and the messages of the domain's own processes. A packet socket captures these (it needs
/// CAP_NET_RAW in the network namespace); they are sent unchanged, mutated or truncated, and half of them with the GUID
/// prefixes of unknown participants, as if these had all endpoints of the domain's participants. The seed determines
/// the choices, as far as the captured messages are the same.
class PacketStorm {
 public:
  PacketStorm(int domain, std::uint32_t seed);
  ~PacketStorm();
  PacketStorm(const PacketStorm&) = delete;
  PacketStorm& operator=(const PacketStorm&) = delete;

  long sent() const noexcept { return sent_; }
  long overheard() const noexcept { return overheard_; }

 private:
  void blow();
  void listen();
  std::string datagram();
  std::string random_bytes(std::size_t most);
  std::string mutated(std::string packet);
  /// The datagram as if sent by one of a few more participants, distinguished by the last byte of their GUID prefix.
  std::string of_stranger(std::string packet);

  const int domain_;
  std::mt19937 random_;
  int ear_ = -1;
  int mouth_ = -1;
  std::deque<std::string> heard_;  // the newest
  std::atomic<long> sent_{0};
  std::atomic<long> overheard_{0};
  std::atomic<bool> over_{false};
  std::thread thread_;
};

}  // namespace mrroc::test
