#include "canopen/frame_text.hpp"

#include <gtest/gtest.h>
#include <linux/can/error.h>

#include <algorithm>

#include "canopen/identifiers.hpp"
#include "canopen/random_frames.hpp"

namespace mrroc::canopen {
namespace {

using can::Frame;

TEST(FrameText, DescribesNetworkManagement) {
  EXPECT_EQ(to_text(sync_frame()), "SYNC");
  EXPECT_EQ(to_text(sync_frame(0xfe)), "SYNC 0FEh");
  EXPECT_EQ(to_text(nmt_frame(NmtCommand::start, 0)), "NMT all nodes: start");
  EXPECT_EQ(to_text(nmt_frame(NmtCommand::enter_pre_operational, 3)), "NMT node 3: enter pre-operational");
  EXPECT_EQ(to_text(Frame{0, {0x77, 3}}), "NMT node 3: unknown");
  EXPECT_EQ(to_text(Frame{0, {1}}), "NMT of 1 bytes");
  EXPECT_EQ(to_text(Frame{0x100, {1, 2, 3, 4, 5, 6}}), "TIME: 01 02 03 04 05 06");
  EXPECT_EQ(to_text(heartbeat_frame(3, NmtState::operational)), "node 3 heartbeat: operational");
  EXPECT_EQ(to_text(heartbeat_frame(127, NmtState::boot_up)), "node 127 heartbeat: boot-up");
  EXPECT_EQ(to_text(Frame{0x703, {0x85}}), "node 3 heartbeat: operational") << "node guarding's toggle bit";
  EXPECT_EQ(to_text(Frame{0x703, {5, 6}}), "node 3 heartbeat of 2 bytes: 05 06");
  EXPECT_EQ(to_text(Frame{0x7e5, {1, 2}}), "7E5h: 01 02");
  EXPECT_EQ(to_text(Frame{0x101, {1}}), "101h: 01");
  Frame fd{0x183, {1, 2}};
  fd.fd = true;
  EXPECT_EQ(to_text(fd), "CAN FD 183h: 01 02") << "not part of the classical profile";
  Frame remote{0x703, {}};
  remote.remote = true;
  EXPECT_EQ(to_text(remote), "request for 703h");
}

TEST(FrameText, DescribesEmergencies) {
  EXPECT_EQ(to_text(Frame{0x083, {0x05, 0x73, 0x21, 1, 2, 3, 4, 5}}),
            "node 3 emergency 7305h: incremental sensor 1 fault, register 21, maker's 01 02 03 04 05");
  EXPECT_EQ(to_text(Frame{0x083, {0x05, 0x73}}), "node 3 emergency of 2 bytes: 05 73");
}

TEST(FrameText, DescribesTransfers) {
  EXPECT_EQ(to_text(Frame{0x603, {0x40, 0x41, 0x60, 0, 0, 0, 0, 0}}), "node 3 SDO read 6041h:0");
  EXPECT_EQ(to_text(Frame{0x583, {0x4b, 0x41, 0x60, 0, 0x37, 0x12, 0, 0}}), "node 3 SDO value 6041h:0 = 37 12");
  EXPECT_EQ(to_text(Frame{0x583, {0x41, 0x08, 0x10, 0, 19, 0, 0, 0}}), "node 3 SDO value 1008h:0, 19 bytes");
  EXPECT_EQ(to_text(Frame{0x583, {0x40, 0x08, 0x10, 0, 0, 0, 0, 0}}), "node 3 SDO value 1008h:0, in segments");
  EXPECT_EQ(to_text(Frame{0x603, {0x2f, 0x60, 0x60, 0, 8, 0, 0, 0}}), "node 3 SDO write 6060h:0 = 08");
  EXPECT_EQ(to_text(Frame{0x583, {0x60, 0x60, 0x60, 0, 0, 0, 0, 0}}), "node 3 SDO written 6060h:0");
  EXPECT_EQ(to_text(Frame{0x583, {0x80, 0x18, 0x10, 9, 0x11, 0, 9, 6}}),
            "node 3 SDO abort 1018h:9: sub-index does not exist");
  EXPECT_EQ(to_text(Frame{0x603, {0x70, 0, 0, 0, 0, 0, 0, 0}}), "node 3 SDO request segment: 70 00 00 00 00 00 00 00");
  EXPECT_EQ(to_text(Frame{0x603, {0x40, 0x41}}), "node 3 SDO request of 2 bytes: 40 41");
}

TEST(FrameText, DescribesProcessData) {
  EXPECT_EQ(to_text(Frame{0x183, {0x37, 0x16}}), "node 3 TPDO 1: 37 16");
  EXPECT_EQ(to_text(Frame{0x203, {0x0f, 0}}), "node 3 RPDO 1: 0f 00");
  EXPECT_EQ(to_text(Frame{0x483, {}}), "node 3 TPDO 4");
  EXPECT_EQ(to_text(Frame{0x57f, {1}}), "node 127 RPDO 4: 01");
  EXPECT_EQ(to_text(Frame{0x180, {1}}), "180h: 01") << "node 0 does not exist";
}

TEST(FrameText, DescribesBusErrors) {
  Frame error;
  error.error = true;
  error.size = 8;
  error.id = CAN_ERR_BUSOFF;
  EXPECT_EQ(to_text(error), "bus: bus off: the controller has left the bus after too many errors");
  error.id = CAN_ERR_CRTL;
  error.data[1] = CAN_ERR_CRTL_TX_PASSIVE;
  EXPECT_EQ(to_text(error), "bus: error passive: the controller has counted more than 127 errors");
}

TEST(FrameText, IsOnePrintableLineForAnyFrame) {
  EXPECT_TRUE(rc::check("any frame", [](const Frame& frame) {
    const std::string text = to_text(frame);
    RC_ASSERT(!text.empty());
    RC_ASSERT(std::all_of(text.begin(), text.end(), [](char letter) { return letter >= 0x20 && letter < 0x7f; }));
  }));
}

}  // namespace
}  // namespace mrroc::canopen
