#include "drivers/ur/rtde/packet.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "drivers/ur/rtde/protocol_error.hpp"

namespace mrroc::ur::rtde::packet_test {
namespace {

using Stream = std::vector<std::uint8_t>;
using Next = PacketBuffer::Next;

void feed(PacketBuffer& buffer, Bytes bytes) {
  const auto space = buffer.free_space();
  ASSERT_GE(space.size(), bytes.size());
  std::copy(bytes.begin(), bytes.end(), space.begin());
  buffer.filled(bytes.size());
}

const std::array kTypes{PacketType::request_protocol_version,
                        PacketType::get_urcontrol_version,
                        PacketType::text_message,
                        PacketType::data_package,
                        PacketType::setup_outputs,
                        PacketType::setup_inputs,
                        PacketType::start,
                        PacketType::pause};

TEST(PacketBuffer, ReturnsAPackageWhenItsLastByteHasCome) {
  Stream stream;
  append_packet(stream, PacketType::data_package, Stream{1, 2, 3});
  EXPECT_EQ(stream, (Stream{0, 6, 'U', 1, 2, 3}));
  PacketBuffer buffer;
  Packet packet;
  for (std::size_t i = 0; i < stream.size(); ++i) {
    EXPECT_EQ(buffer.next(packet), Next::incomplete) << i;
    feed(buffer, Bytes(stream).subspan(i, 1));
  }
  ASSERT_EQ(buffer.next(packet), Next::packet);
  EXPECT_EQ(packet.type, PacketType::data_package);
  EXPECT_TRUE(std::ranges::equal(packet.payload, Stream{1, 2, 3}));
  EXPECT_EQ(buffer.next(packet), Next::incomplete);
}

RC_GTEST_PROP(PacketBuffer, EveryPartitionOfAStreamGivesTheSamePackages, (const std::vector<Stream>& payloads)) {
  Stream stream;
  for (std::size_t i = 0; i < payloads.size(); ++i) append_packet(stream, kTypes[i % kTypes.size()], payloads[i]);
  PacketBuffer buffer;
  Packet packet;
  std::size_t taken = 0;
  for (std::size_t at = 0; at < stream.size();) {
    const std::size_t size = std::min(*rc::gen::inRange<std::size_t>(1, 40), stream.size() - at);
    feed(buffer, Bytes(stream).subspan(at, size));
    at += size;
    while (buffer.next(packet) == Next::packet) {
      RC_ASSERT(taken < payloads.size());
      RC_ASSERT(packet.type == kTypes[taken % kTypes.size()]);
      RC_ASSERT(std::ranges::equal(packet.payload, payloads[taken]));
      ++taken;
    }
  }
  RC_ASSERT(taken == payloads.size());
}

TEST(PacketBuffer, InvalidHeaderBreaksTheStream) {
  for (const Stream& header : {Stream{0, 2, 'U'}, Stream{0, 0, 'U'}, Stream{0, 4, 'x'}, Stream{0, 4, 0}}) {
    PacketBuffer buffer;
    Packet packet;
    feed(buffer, header);
    EXPECT_EQ(buffer.next(packet), Next::broken);
    EXPECT_EQ(buffer.next(packet), Next::broken);
  }
}

TEST(PacketBuffer, CarriesTheLongestPackage) {
  Stream stream;
  append_packet(stream, PacketType::text_message, Stream(kMaxPayload, 7));
  PacketBuffer buffer;
  Packet packet;
  for (int i = 0; i < 5; ++i) {
    feed(buffer, stream);
    ASSERT_EQ(buffer.next(packet), Next::packet);
    EXPECT_EQ(packet.payload.size(), kMaxPayload);
    EXPECT_GE(buffer.free_space().size(), kMaxPacket);
  }
  EXPECT_THROW(append_packet(stream, PacketType::text_message, Stream(kMaxPayload + 1, 7)), ProtocolError);
}

}  // namespace
}  // namespace mrroc::ur::rtde::packet_test
