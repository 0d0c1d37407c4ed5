#include "drivers/ur/rtde/packet.hpp"

#include <algorithm>

#include "drivers/ur/rtde/protocol_error.hpp"

namespace mrroc::ur::rtde {

bool is_packet_type(std::uint8_t letter) noexcept {
  switch (static_cast<PacketType>(letter)) {
    case PacketType::request_protocol_version:
    case PacketType::get_urcontrol_version:
    case PacketType::text_message:
    case PacketType::data_package:
    case PacketType::setup_outputs:
    case PacketType::setup_inputs:
    case PacketType::start:
    case PacketType::pause:
      return true;
  }
  return false;
}

void append_packet(std::vector<std::uint8_t>& stream, PacketType type, Bytes payload) {
  if (payload.size() > kMaxPayload)
    throw ProtocolError("a payload of " + std::to_string(payload.size()) + " bytes, the maximum is " +
                        std::to_string(kMaxPayload));
  std::array<std::uint8_t, kHeaderSize> header{};
  WireWriter writer(header);
  writer.put(static_cast<std::uint16_t>(kHeaderSize + payload.size()));
  writer.put(static_cast<std::uint8_t>(type));
  stream.insert(stream.end(), header.begin(), header.end());
  stream.insert(stream.end(), payload.begin(), payload.end());
}

std::span<std::uint8_t> PacketBuffer::free_space() noexcept {
  if (begin_ > 0) {
    std::copy(memory_.begin() + static_cast<std::ptrdiff_t>(begin_),
              memory_.begin() + static_cast<std::ptrdiff_t>(end_), memory_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  return std::span(memory_).subspan(end_);
}

PacketBuffer::Next PacketBuffer::next(Packet& packet) noexcept {
  const Bytes bytes = Bytes(memory_).subspan(begin_, end_ - begin_);
  if (bytes.size() < kHeaderSize) return Next::incomplete;
  WireReader header(bytes);
  const std::size_t length = header.take<std::uint16_t>();
  const auto letter = header.take<std::uint8_t>();
  if (length < kHeaderSize || !is_packet_type(letter)) return Next::broken;
  if (bytes.size() < length) return Next::incomplete;
  packet = {static_cast<PacketType>(letter), bytes.subspan(kHeaderSize, length - kHeaderSize)};
  begin_ += length;
  return Next::packet;
}

}  // namespace mrroc::ur::rtde
