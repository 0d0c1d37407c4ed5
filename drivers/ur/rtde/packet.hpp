#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "drivers/ur/rtde/wire.hpp"

namespace mrroc::ur::rtde {

/// Kinds of packages, each with the letter of the RTDE guide.
enum class PacketType : std::uint8_t {
  request_protocol_version = 'V',
  get_urcontrol_version = 'v',
  text_message = 'M',
  data_package = 'U',
  setup_outputs = 'O',
  setup_inputs = 'I',
  start = 'S',
  pause = 'P'
};

bool is_packet_type(std::uint8_t letter) noexcept;

/// One package of the stream: its kind and the bytes after its header.
struct Packet {
  PacketType type{};
  Bytes payload;
};

inline constexpr std::size_t kHeaderSize = 3;      ///< length of the whole package (16 bits), kind
inline constexpr std::size_t kMaxPacket = 0xffff;  ///< bytes, header included
inline constexpr std::size_t kMaxPayload = kMaxPacket - kHeaderSize;

/// Appends a package to `stream`. Throws ProtocolError when the payload is longer than kMaxPayload.
void append_packet(std::vector<std::uint8_t>& stream, PacketType type, Bytes payload);

/// Cuts a stream of bytes into packages. A stream whose header cannot be one (a length below 3, an unknown kind) is
/// broken for good: RTDE has no mark by which a receiver could find the next package. After the constructor it
/// allocates nothing; it never throws.
class PacketBuffer {
 public:
  PacketBuffer() : memory_(2 * kMaxPacket) {}

  /// Memory for the next received bytes, at least one package long. Invalidates packages.
  std::span<std::uint8_t> free_space() noexcept;
  /// `size` bytes of `free_space` have been filled.
  void filled(std::size_t size) noexcept { end_ += size; }

  enum class Next { packet, incomplete, broken };
  /// Takes the next package; it is valid until `free_space` is called.
  Next next(Packet& packet) noexcept;

  /// Forgets all bytes, for a new connection.
  void clear() noexcept { begin_ = end_ = 0; }

 private:
  std::vector<std::uint8_t> memory_;
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace mrroc::ur::rtde
