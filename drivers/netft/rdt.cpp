#include "drivers/netft/rdt.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mrroc::netft {

namespace {

void put(std::span<std::uint8_t> to, std::uint32_t value) noexcept {
  const std::size_t size = to.size();
  for (std::size_t i = 0; i < size; ++i) to[i] = static_cast<std::uint8_t>(value >> (8 * (size - 1 - i)));
}

std::uint32_t get(std::span<const std::uint8_t> from) noexcept {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : from) value = value << 8 | byte;
  return value;
}

bool is_command(std::uint32_t value) noexcept {
  switch (static_cast<Command>(value)) {
    case Command::stop:
    case Command::start_realtime:
    case Command::start_buffered:
    case Command::start_multi_unit:
    case Command::reset_threshold:
    case Command::set_bias:
      return true;
  }
  return false;
}

constexpr std::array<StatusBit, 30> kStatusBits{{
    {kErrorSummary, "error"},
    {0x4000'0000, "CPU or RAM error"},
    {0x2000'0000, "digital board error"},
    {0x1000'0000, "analog board error"},
    {0x0800'0000, "serial link communication error"},
    {0x0400'0000, "program memory verification error"},
    {0x0200'0000, "halted due to configuration errors"},
    {0x0100'0000, "settings validation error"},
    {0x0080'0000, "configuration settings incompatible with the calibration"},
    {0x0040'0000, "network communication failure"},
    {0x0020'0000, "CAN communication error"},
    {0x0010'0000, "RDT communication error"},
    {0x0008'0000, "EtherNet/IP protocol failure"},
    {0x0004'0000, "DeviceNet protocol failure"},
    {kSaturated, "transducer saturation or A/D error"},
    {kMonitorCondition, "monitor condition latched"},
    {0x0000'4000, "watchdog timeout"},
    {0x0000'2000, "stack check error"},
    {0x0000'1000, "serial EEPROM (I2C) failure"},
    {0x0000'0800, "serial flash (SPI) failure"},
    {0x0000'0400, "analog board watchdog timeout"},
    {0x0000'0200, "excessive strain gage excitation current"},
    {0x0000'0100, "insufficient strain gage excitation current"},
    {0x0000'0080, "artificial analog ground out of range"},
    {0x0000'0040, "analog board power supply too high"},
    {0x0000'0020, "analog board power supply too low"},
    {0x0000'0010, "serial link data unavailable"},
    {0x0000'0008, "reference voltage or power monitoring error"},
    {0x0000'0004, "internal temperature error"},
    {0x0000'0002, "HTTP protocol failure"},
}};

/// Appends to a buffer as far as there is room.
class Line {
 public:
  void add(std::string_view text) noexcept {
    const std::size_t size = std::min(text.size(), line_.size() - size_);
    std::copy_n(text.begin(), size, line_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += size;
  }
  std::string_view text() const noexcept { return {line_.data(), size_}; }

 private:
  std::array<char, 256> line_{};
  std::size_t size_ = 0;
};

std::string_view name_of(std::uint32_t bit) noexcept {
  for (const StatusBit& each : kStatusBits) {
    if (each.mask == bit) return each.name;
  }
  return {};
}

}  // namespace

std::array<std::uint8_t, kRequestSize> encode(const Request& request) noexcept {
  std::array<std::uint8_t, kRequestSize> packet{};
  const std::span<std::uint8_t> all(packet);
  put(all.subspan(0, 2), kRdtHeader);
  put(all.subspan(2, 2), static_cast<std::uint16_t>(request.command));
  put(all.subspan(4, 4), request.count);
  return packet;
}

std::optional<Request> decode_request(std::span<const std::uint8_t> packet) noexcept {
  if (packet.size() != kRequestSize || get(packet.subspan(0, 2)) != kRdtHeader) return {};
  const std::uint32_t command = get(packet.subspan(2, 2));
  if (!is_command(command)) return {};
  return Request{static_cast<Command>(command), get(packet.subspan(4, 4))};
}

std::array<std::uint8_t, kRecordSize> encode(const Record& record) noexcept {
  std::array<std::uint8_t, kRecordSize> packet{};
  const std::span<std::uint8_t> all(packet);
  put(all.subspan(0, 4), record.rdt_sequence);
  put(all.subspan(4, 4), record.ft_sequence);
  put(all.subspan(8, 4), record.status);
  for (std::size_t i = 0; i < record.counts.size(); ++i) {
    put(all.subspan(12 + 4 * i, 4), static_cast<std::uint32_t>(record.counts[i]));
  }
  return packet;
}

std::size_t records_in(std::size_t size) noexcept {
  return size % kRecordSize == 0 && size <= kMaxPacketSize ? size / kRecordSize : 0;
}

Record decode_record(std::span<const std::uint8_t> packet, std::size_t index) noexcept {
  const std::span<const std::uint8_t> all = packet.subspan(index * kRecordSize, kRecordSize);
  Record record{get(all.subspan(0, 4)), get(all.subspan(4, 4)), get(all.subspan(8, 4)), {}};
  for (std::size_t i = 0; i < record.counts.size(); ++i) {
    record.counts[i] = static_cast<std::int32_t>(get(all.subspan(12 + 4 * i, 4)));
  }
  return record;
}

std::uint32_t measurements_until(std::int64_t ns) noexcept {
  return static_cast<std::uint32_t>(std::llround(static_cast<double>(ns) * 1e-9 * kMaxRate));
}

std::span<const StatusBit> status_bits() noexcept { return kStatusBits; }

bool is_valid(std::uint32_t status) noexcept { return status == 0 || (status & ~kErrorSummary) == kMonitorCondition; }

StatusText status_text(std::uint32_t status) noexcept {
  Line line;
  std::array<char, 24> word{};
  std::snprintf(word.data(), word.size(), "0x%08x: ", static_cast<unsigned>(status));
  line.add(word.data());
  if (status == 0) line.add("healthy");
  const std::uint32_t shown = status == kErrorSummary ? status : status & ~kErrorSummary;
  bool first = true;
  for (int i = 31; i >= 0; --i) {
    const std::uint32_t bit = std::uint32_t{1} << i;
    if ((shown & bit) == 0) continue;
    if (!first) line.add(", ");
    first = false;
    const std::string_view name = name_of(bit);
    if (name.empty()) {
      std::snprintf(word.data(), word.size(), "reserved bit %d", i);
      line.add(word.data());
    } else {
      line.add(name);
    }
  }
  return StatusText{line.text()};
}

}  // namespace mrroc::netft
