#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mrroc/fixed_text.hpp"

/// Raw Data Transfer (RDT), the UDP protocol of the ATI Net F/T: ATI Industrial Automation, "Net F/T Installation and
/// Operation Manual", 9620-05-NET FT, section "UDP Interface Using RDT". Every field is big-endian. Pure functions; any
/// thread; nothing here allocates unless it returns a std::string.
namespace mrroc::netft {

inline constexpr std::uint16_t kRdtPort = 49152;
inline constexpr std::uint16_t kRdtHeader = 0x1234;
inline constexpr std::size_t kRequestSize = 8;
inline constexpr std::size_t kRecordSize = 36;
/// Records in one packet of the buffered mode: the manual's maximum of the setting "RDT Buffer Size".
inline constexpr std::size_t kMaxRecords = 40;
inline constexpr std::size_t kMaxPacketSize = kMaxRecords * kRecordSize;
/// Highest rate at which a Net F/T measures and sends, Hz.
inline constexpr double kMaxRate = 7000;

enum class Command : std::uint16_t {
  stop = 0x0000,
  start_realtime = 0x0002,    ///< one record in a packet
  start_buffered = 0x0003,    ///< several records in a packet
  start_multi_unit = 0x0004,  ///< as start_realtime, from several Net F/Ts
  reset_threshold = 0x0041,   ///< clears the latch of the monitor conditions
  set_bias = 0x0042           ///< the present load becomes the zero of all clients
};

struct Request {
  Command command = Command::stop;
  std::uint32_t count = 0;  ///< records to be sent; 0: without end
  friend bool operator==(const Request&, const Request&) = default;
};

struct Record {
  std::uint32_t rdt_sequence = 0;  ///< number in the stream of one request; 1 is the first
  std::uint32_t ft_sequence = 0;   ///< number of the measurement since the sensor was switched on
  std::uint32_t status = 0;
  std::array<std::int32_t, 6> counts{};  ///< force x, y, z, torque x, y, z: the load on the tool's side
  friend bool operator==(const Record&, const Record&) = default;
};

std::array<std::uint8_t, kRequestSize> encode(const Request& request) noexcept;
/// Nothing: another size, another header or an unknown command.
std::optional<Request> decode_request(std::span<const std::uint8_t> packet) noexcept;

std::array<std::uint8_t, kRecordSize> encode(const Record& record) noexcept;
/// Number of records in a packet of `size` bytes; 0: it is not a packet of 1 to kMaxRecords whole records.
std::size_t records_in(std::size_t size) noexcept;
/// Record `index` of a packet; `index` < records_in(packet.size()).
Record decode_record(std::span<const std::uint8_t> packet, std::size_t index = 0) noexcept;

/// `Record::ft_sequence` at `ns` after the sensor was switched on.
std::uint32_t measurements_until(std::int64_t ns) noexcept;

/// One bit of the status word and its name in the manual, section "System Status Code", table "System Status Code Bit
/// Assignments".
struct StatusBit {
  std::uint32_t mask;
  std::string_view name;
};

inline constexpr std::uint32_t kErrorSummary = 0x8000'0000;
inline constexpr std::uint32_t kMonitorCondition = 0x0001'0000;
inline constexpr std::uint32_t kSaturated = 0x0002'0000;

/// All bits that have a meaning, the highest first.
std::span<const StatusBit> status_bits() noexcept;
/// Whether the counts are those of the load. The latch of the monitor conditions, which the user defines in the sensor,
/// and the error summary that it sets do not make them invalid; every other bit does, reserved ones included.
bool is_valid(std::uint32_t status) noexcept;

using StatusText = FixedText<160>;
/// "0x80020000: transducer saturation or A/D error": the word and the names of its bits, the error summary only when it
/// is alone; "0x00000000: healthy". Reserved bits are "reserved bit N". Text that is too long is cut.
StatusText status_text(std::uint32_t status) noexcept;

}  // namespace mrroc::netft
