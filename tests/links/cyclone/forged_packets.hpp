#pragma once

#include <arpa/inet.h>
#include <dds/dds.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "links/transport/descriptors.hpp"

namespace mrroc::links {

/// Prefix (12 bytes, of the participant) and entity number (4), as on the wire.
using Guid = std::array<std::uint8_t, 16>;

/// RTPS bytes as an eavesdropper who follows the standard would write them. Little-endian.
class Packet {
 public:
  explicit Packet(const Guid& sender) {
    bytes_.append("RTPS\x02\x01\x01\x10", 8);
    append(sender.data(), 12);
  }
  Packet& byte(int value) { return append(&value, 1); }
  Packet& half(int value) { return append(&value, 2); }
  Packet& word(std::uint32_t value) { return append(&value, 4); }
  Packet& sequence(std::uint64_t value) {
    return word(static_cast<std::uint32_t>(value >> 32)).word(static_cast<std::uint32_t>(value));
  }
  Packet& raw(std::initializer_list<int> values) {
    for (const int value : values) byte(value);
    return *this;
  }
  Packet& append(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// "All that I have sent up to 2^32 is gone": a reliable reader that accepts it skips the real messages.
inline std::string forged_heartbeat(const Guid& writer, std::uint32_t count) {
  constexpr std::uint64_t kFuture = (1ULL << 32) + 1;
  Packet packet(writer);
  packet.raw({0x07, 0x01}).half(28).word(0).append(writer.data() + 12, 4);
  return packet.sequence(kFuture).sequence(kFuture).word(count).bytes();
}

/// "I have left": the message of a participant at its end (SPDP, dispose and unregister).
inline std::string forged_farewell(const Guid& participant, std::uint64_t sequence) {
  Packet packet(participant);
  packet.raw({0x15, 0x0b}).half(20 + 12 + 28).half(0).half(16);
  packet.raw({0x00, 0x01, 0x00, 0xc7, 0x00, 0x01, 0x00, 0xc2}).sequence(sequence);
  packet.half(0x0071).half(4).raw({0, 0, 0, 3}).half(1).half(0);  // status: disposed, unregistered
  packet.raw({0x00, 0x03, 0x00, 0x00}).half(0x0050).half(16).append(participant.data(), 16).half(1).half(0);
  return packet.bytes();
}

/// Ports of this process's DDS, started since `before`. In network order.
inline std::vector<in_port_t> ports_since(const std::set<int>& before) {
  std::vector<in_port_t> ports;
  for (const int fd : open_descriptors()) {
    if (before.contains(fd) || !is_udp_socket(fd)) continue;
    sockaddr_in address{};
    socklen_t size = sizeof address;
    if (::getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) == 0) ports.push_back(address.sin_port);
  }
  return ports;
}

/// Sends datagrams to ports of this machine.
class LoopbackSender {
 public:
  explicit LoopbackSender(std::vector<in_port_t> ports)
      : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)), ports_(std::move(ports)) {}
  ~LoopbackSender() { ::close(socket_); }
  LoopbackSender(const LoopbackSender&) = delete;
  LoopbackSender& operator=(const LoopbackSender&) = delete;

  void send(const std::string& datagram) const {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    for (const in_port_t port : ports_) {
      address.sin_port = port;
      ::sendto(socket_, datagram.data(), datagram.size(), 0, reinterpret_cast<const sockaddr*>(&address),
               sizeof address);
    }
  }

 private:
  int socket_;
  std::vector<in_port_t> ports_;
};

/// The writer of `topic` that `participant` has discovered and that is not its own; nothing while there is none.
inline std::optional<Guid> foreign_writer(dds_entity_t participant, const std::string& topic) {
  dds_guid_t own{};
  dds_get_guid(participant, &own);
  const dds_entity_t reader = dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr);
  std::optional<Guid> found;
  std::array<void*, 64> samples{};
  std::array<dds_sample_info_t, 64> infos{};
  const int count = dds_take(reader, samples.data(), infos.data(), samples.size(), samples.size());
  for (int i = 0; i < count; ++i) {
    const auto* endpoint = static_cast<const dds_builtintopic_endpoint_t*>(samples[static_cast<std::size_t>(i)]);
    if (!infos[static_cast<std::size_t>(i)].valid_data || topic != endpoint->topic_name) continue;
    if (std::equal(own.v, own.v + 12, endpoint->key.v)) continue;
    found.emplace();
    std::copy_n(endpoint->key.v, found->size(), found->begin());
  }
  if (count > 0) dds_return_loan(reader, samples.data(), count);
  dds_delete(reader);
  return found;
}

}  // namespace mrroc::links
