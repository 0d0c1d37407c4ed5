#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

namespace mrroc::can {

/// Maximum data bytes of a classical frame (ISO 11898-1), as used by CANopen's classical profile (CiA 301).
inline constexpr std::size_t kMaxClassicalData = 8;
/// Maximum data bytes of a CAN FD frame.
inline constexpr std::size_t kMaxData = 64;

/// One frame of a CAN bus, base format: 11 bits of identifier, at most 8 bytes of data, or with `fd` 64. A controller's
/// reports about the bus (`linux/can/error.h`) are frames with `error`.
struct Frame {
  std::uint32_t id = 0;          ///< 0..0x7ff; of an error frame its class bits
  std::uint8_t size = 0;         ///< bytes of data in use; with `fd` 0..8, 12, 16, 20, 24, 32, 48 or 64
  bool remote = false;           ///< requests the data of `id`
  bool error = false;            ///< from the controller, not from the bus
  bool fd = false;               ///< of CAN FD
  bool bit_rate_switch = false;  ///< CAN FD: the data at the higher bit rate
  std::array<std::uint8_t, kMaxData> data{};

  Frame() = default;
  /// A data frame; at most 8 bytes.
  Frame(std::uint32_t identifier, std::initializer_list<std::uint8_t> bytes) : id(identifier) {
    for (const std::uint8_t byte : bytes)
      if (size < kMaxClassicalData) data[size++] = byte;
  }
  std::span<const std::uint8_t> bytes() const noexcept { return {data.data(), size}; }
  friend bool operator==(const Frame&, const Frame&) = default;
};

/// Little-endian numbers, CANopen's order (CiA 301, 7.1.4). `size` 1..8; bytes beyond the data are 0.
inline std::uint64_t get(std::span<const std::uint8_t> data, std::size_t offset, std::size_t size) noexcept {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size && offset + i < data.size(); ++i)
    value |= static_cast<std::uint64_t>(data[offset + i]) << (8 * i);
  return value;
}

inline void put(std::span<std::uint8_t> data, std::size_t offset, std::size_t size, std::uint64_t value) noexcept {
  for (std::size_t i = 0; i < size && offset + i < data.size(); ++i)
    data[offset + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

/// The number of `size` bytes (1..8) with its sign.
inline std::int64_t sign_extended(std::uint64_t value, std::size_t size) noexcept {
  const auto shift = static_cast<unsigned>(64 - 8 * size);
  return static_cast<std::int64_t>(value << shift) >> shift;
}

}  // namespace mrroc::can
