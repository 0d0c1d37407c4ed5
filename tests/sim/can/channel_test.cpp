#include "sim/can/channel.hpp"

#include <gtest/gtest.h>

#include "canopen/emergency.hpp"
#include "canopen/sdo.hpp"

namespace mrroc::sim::channel_test {
namespace {

using namespace canopen;

/// Two axes of node 5, whose PDOs begin at 1 and 65, and a drive of its own.
config::DriveTable table() {
  config::DriveTable table;
  const auto add = [&table](int node, int channel, int first_pdo) {
    config::DriveEntry entry;
    entry.node = static_cast<NodeId>(node);
    entry.channel = channel;
    entry.first_pdo = first_pdo;
    table.drives.push_back(entry);
  };
  add(5, 1, 1);
  add(7, 1, 1);
  add(5, 2, 65);
  return table;
}

can::Frame request(Object object) { return SdoTransfer{}.upload(5, object); }

Object object_in(const can::Frame& frame) {
  return {static_cast<std::uint16_t>(can::get(frame.data, 1, 2)), frame.data[3]};
}

/// The object that an axis is asked for; 0: it is not asked.
Object asked(const Channel& axis, Object object) {
  const auto frame = axis.received(request(object));
  return frame ? object_in(*frame) : Object{};
}

can::Frame answer(const can::Frame& frame) {
  can::Frame answered = frame;
  answered.id = kSdoResponse + 5;
  answered.data[0] = 0x43;
  return answered;
}

TEST(Channel, PassesTheObjectsOfEachAxisToIt) {
  const config::DriveTable drives = table();
  const Channel first(drives, drives.drives[0]), second(drives, drives.drives[2]);
  EXPECT_EQ(asked(first, kControlword), kControlword);
  EXPECT_EQ(asked(second, kControlword), Object{});
  EXPECT_EQ(asked(first, {0x6840}), Object{});
  EXPECT_EQ(asked(second, {0x6840}), kControlword);
  EXPECT_EQ(asked(first, {0x1401, 2}), (Object{0x1401, 2}));
  EXPECT_EQ(asked(second, {0x1440, 2}), (Object{0x1400, 2}));
  EXPECT_EQ(asked(second, {0x1a41, 3}), (Object{0x1a01, 3}));
  EXPECT_EQ(asked(first, kProducerHeartbeat), kProducerHeartbeat);
  EXPECT_EQ(asked(second, kProducerHeartbeat), kProducerHeartbeat) << "what all have in common is written to each";
}

TEST(Channel, AnswersForItsNode) {
  const config::DriveTable drives = table();
  const Channel first(drives, drives.drives[0]), second(drives, drives.drives[2]);
  for (const Object object : {Object{0x6840}, Object{0x1440, 1}, Object{0x1a41, 3}}) {
    const auto asked = second.received(request(object));
    ASSERT_TRUE(asked);
    const auto sent = second.sent(answer(*asked));
    ASSERT_TRUE(sent);
    EXPECT_EQ(object_in(*sent), object);
  }
  EXPECT_TRUE(first.sent(answer(request(kProducerHeartbeat))));
  EXPECT_FALSE(second.sent(answer(request(kProducerHeartbeat))));
  EXPECT_TRUE(first.sent(heartbeat_frame(5, NmtState::boot_up)));
  EXPECT_FALSE(second.sent(heartbeat_frame(5, NmtState::boot_up)));
  EXPECT_TRUE(second.sent(to_frame({5, 0x7305, 0, {}})));
}

TEST(Channel, MapsTheObjectsOfItsAxis) {
  const config::DriveTable drives = table();
  const Channel second(drives, drives.drives[2]);
  can::Frame write{kSdoRequest + 5, {0x23, 0x40, 0x16, 1, 0x10, 0x00, 0x40, 0x68}};  // 1640h:1 = 6840h, 16 bits
  const auto own = second.received(write);
  ASSERT_TRUE(own);
  EXPECT_EQ(object_in(*own), (Object{0x1600, 1}));
  EXPECT_EQ(can::get(own->data, 4, 4), 0x60400010u);
}

TEST(Channel, LeavesDrivesWithOneAxisAlone) {
  const config::DriveTable drives = table();
  const Channel single(drives, drives.drives[1]);
  for (const can::Frame& frame : {request({0x6840}), heartbeat_frame(7, NmtState::operational)}) {
    EXPECT_EQ(single.received(frame), frame);
    EXPECT_EQ(single.sent(frame), frame);
  }
}

}  // namespace
}  // namespace mrroc::sim::channel_test
