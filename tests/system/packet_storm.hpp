#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <random>
#include <string>
#include <thread>

namespace mrroc::test {

/// Floods the RTPS ports of a DDS domain of this machine with datagrams for as long as it lives: random bytes, RTPS
/// headers with anything behind, and what the domain's own processes send to one another, overheard by
/// a packet socket (which needs CAP_NET_RAW in the network namespace), as it is, mutated or truncated, and half of it
/// as if unknown participants had sent it that have all that the domain's participants have. The choices follow from
/// the seed, as far as what is overheard is the same.
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
  /// As if one of a few more participants, distinguished by the last byte of their GUID prefix, had sent it.
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
