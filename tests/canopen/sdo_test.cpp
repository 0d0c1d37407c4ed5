#include "canopen/sdo.hpp"

#include <gtest/gtest.h>

#include "canopen/plain_server.hpp"
#include "canopen/random_frames.hpp"

namespace mrroc::canopen {
namespace {

using test::PlainServer;
using Status = SdoTransfer::Status;

constexpr NodeId kServedNode = 5;
constexpr Object kThing{0x2001, 3};

/// Passes frames between client and server until the transfer is complete, or no answer comes.
void carry(SdoTransfer& transfer, PlainServer& server, can::Frame frame) {
  for (int i = 0; i < 1000 && transfer.status() == Status::waiting; ++i) {
    const auto answer = server.answer(frame);
    if (!answer) return;
    ASSERT_TRUE(transfer.take(*answer, frame));
  }
}

std::vector<std::uint8_t> value_of(const SdoTransfer& transfer) {
  return {transfer.value().begin(), transfer.value().end()};
}

TEST(Sdo, ReadsWhatWasWritten) {
  EXPECT_TRUE(rc::check("any value, with or without its size in the answer", [](bool tells_size, Object object) {
    PlainServer server(kServedNode);
    server.tells_size = tells_size;
    server.values[object] = {1};
    const auto value = test::random_value(0, kMaxValue);
    SdoTransfer transfer;
    carry(transfer, server, transfer.download(kServedNode, object, value));
    RC_ASSERT(transfer.status() == Status::done);
    RC_ASSERT(server.values[object] == value);
    carry(transfer, server, transfer.upload(kServedNode, object));
    RC_ASSERT(transfer.status() == Status::done);
    RC_ASSERT(value_of(transfer) == value);
  }));
}

TEST(Sdo, RefusesAValueThatIsTooLong) {
  for (const bool tells_size : {true, false}) {
    PlainServer server(kServedNode);
    server.tells_size = tells_size;
    server.values[kThing].resize(kMaxValue + 1, 7);
    SdoTransfer transfer;
    carry(transfer, server, transfer.upload(kServedNode, kThing));
    EXPECT_EQ(transfer.status(), Status::refused);
    EXPECT_EQ(transfer.abort(), SdoAbort::out_of_memory);
  }
}

TEST(Sdo, WrongToggleBitEndsTransfer) {
  PlainServer server(kServedNode);
  server.spoils_toggle = true;
  server.values[kThing].resize(20);
  SdoTransfer transfer;
  carry(transfer, server, transfer.upload(kServedNode, kThing));
  EXPECT_EQ(transfer.abort(), SdoAbort::toggle_bit);
  carry(transfer, server, transfer.download(kServedNode, kThing, std::vector<std::uint8_t>(20)));
  EXPECT_EQ(transfer.status(), Status::refused);
  EXPECT_EQ(transfer.abort(), SdoAbort::toggle_bit);
}

TEST(Sdo, RejectsFewerBytesThanAnnounced) {
  SdoTransfer transfer;
  transfer.upload(kServedNode, kThing);
  can::Frame next;
  EXPECT_TRUE(transfer.take({0x585, {0x41, 0x01, 0x20, 3, 9, 0, 0, 0}}, next));
  EXPECT_EQ(next, (can::Frame{0x605, {0x60, 0, 0, 0, 0, 0, 0, 0}}));
  EXPECT_TRUE(transfer.take({0x585, {0x01, 1, 2, 3, 4, 5, 6, 7}}, next));
  EXPECT_EQ(transfer.abort(), SdoAbort::wrong_length);
  EXPECT_EQ(next, (can::Frame{0x605, {0x80, 0x01, 0x20, 3, 0x10, 0, 0x07, 0x06}}));
}

TEST(Sdo, RefusalOfTheServerHasItsText) {
  PlainServer server(kServedNode);
  SdoTransfer transfer;
  carry(transfer, server, transfer.upload(kServedNode, kThing));
  EXPECT_EQ(transfer.status(), Status::refused);
  EXPECT_EQ(describe(transfer.abort()), "object does not exist in the object dictionary");
  EXPECT_EQ(describe(SdoAbort::none), "no abort");
  EXPECT_EQ(describe(SdoAbort::wrong_state), "data cannot be transferred because of the present device state");
  EXPECT_EQ(describe(static_cast<SdoAbort>(0x06090032)), "value of parameter written too low");
  EXPECT_EQ(describe(static_cast<SdoAbort>(0x12345678)), "unknown abort code");
}

TEST(Sdo, IgnoresFramesOfOthers) {
  SdoTransfer transfer;
  can::Frame next;
  const can::Frame answer{0x585, {0x43, 0x01, 0x20, 3, 1, 2, 3, 4}};
  EXPECT_FALSE(transfer.take(answer, next)) << "no request is open";
  transfer.upload(kServedNode, kThing);
  can::Frame other = answer;
  other.id = 0x586;
  EXPECT_FALSE(transfer.take(other, next)) << "another node";
  other = answer;
  other.size = 7;
  EXPECT_FALSE(transfer.take(other, next)) << "too short";
  other.size = 12;
  EXPECT_FALSE(transfer.take(other, next)) << "too long";
  other = answer;
  other.fd = true;
  EXPECT_FALSE(transfer.take(other, next)) << "not a classical frame";
  other = answer;
  other.remote = true;
  EXPECT_FALSE(transfer.take(other, next));
  EXPECT_FALSE(transfer.take({0x585, {0x43, 0x02, 0x20, 3, 1, 2, 3, 4}}, next)) << "a late answer";
  EXPECT_FALSE(transfer.take({0x585, {0x80, 0x02, 0x20, 3, 0, 0, 2, 6}}, next)) << "a late abort";
  EXPECT_FALSE(transfer.take({0x585, {0x01, 0x01, 0x20, 3, 1, 2, 3, 4}}, next)) << "a late segment";
  EXPECT_TRUE(transfer.take(answer, next));
  EXPECT_EQ(value_of(transfer), (std::vector<std::uint8_t>{1, 2, 3, 4}));
  EXPECT_FALSE(transfer.take(answer, next)) << "it has been answered";
}

TEST(Sdo, LateAnswerDoesNotDisturbSegments) {
  PlainServer server(kServedNode);
  server.values[kThing] = std::vector<std::uint8_t>(30, 9);
  SdoTransfer transfer;
  can::Frame frame;
  ASSERT_TRUE(transfer.take(*server.answer(transfer.upload(kServedNode, kThing)), frame));
  can::Frame next;
  EXPECT_FALSE(transfer.take({0x585, {0x60, 0x17, 0x10, 0, 0, 0, 0, 0}}, next));
  carry(transfer, server, frame);
  EXPECT_EQ(value_of(transfer), server.values[kThing]);
}

TEST(Sdo, SurvivesAnyFrames) {
  EXPECT_TRUE(rc::check("a random sequence", [](bool writes, Object object) {
    const auto value = test::random_value(0, kMaxValue);
    SdoTransfer transfer;
    const can::Frame request =
        writes ? transfer.download(kServedNode, object, value) : transfer.upload(kServedNode, object);
    RC_ASSERT(request.id == kSdoRequest + kServedNode);
    const auto frames = *rc::gen::container<std::vector<can::Frame>>(60, rc::gen::arbitrary<can::Frame>());
    for (can::Frame frame : frames) {
      // most of them almost valid
      const int kind = *rc::gen::inRange(0, 8);
      if (kind > 0) {
        frame.id = kSdoResponse + kServedNode;
        frame.size = 8;
        frame.fd = frame.error = frame.remote = false;
      }
      if (kind > 2) {
        can::put(frame.data, 1, 2, object.index);
        frame.data[3] = object.sub;
      }
      if (kind > 4) frame.data[0] = static_cast<std::uint8_t>(frame.data[0] & 0x7e);
      const Status before = transfer.status();
      const std::size_t size = transfer.value().size();
      can::Frame next;
      const bool taken = transfer.take(frame, next);
      RC_ASSERT(transfer.value().size() <= kMaxValue);
      RC_ASSERT(!writes || transfer.value().size() == size);
      RC_ASSERT(taken || (next.id == 0 && transfer.status() == before));
      RC_ASSERT(next.id == 0 || (next.id == kSdoRequest + kServedNode && next.size == 8));
      RC_ASSERT(before == Status::waiting || !taken);
      RC_ASSERT(transfer.status() != Status::waiting || !taken || next.id != 0);
    }
  }));
}

}  // namespace
}  // namespace mrroc::canopen
