#include "can/raw_frame.hpp"

#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "can/bus_error.hpp"
#include "canopen/random_frames.hpp"

namespace mrroc::can {
namespace {

TEST(RawFrame, RoundTripsToTheSameFrame) {
  EXPECT_TRUE(rc::check("classical and CAN FD", [](Frame frame, bool fast) {
    frame.bit_rate_switch = frame.fd && fast;
    if (frame.error) frame.remote = frame.fd = frame.bit_rate_switch = false;
    frame.size = std::min<std::uint8_t>(frame.size, frame.fd ? kMaxData : kMaxClassicalData);
    std::fill(frame.data.begin() + frame.size, frame.data.end(), std::uint8_t{0});
    canfd_frame raw;
    const std::size_t size = to_raw(frame, raw);
    RC_ASSERT(size == (frame.fd ? sizeof(canfd_frame) : sizeof(can_frame)));
    Frame back;
    RC_ASSERT(from_raw(raw, size, back));
    RC_ASSERT(back == frame);
  }));
}

TEST(RawFrame, RejectsEverythingElse) {
  canfd_frame raw{};
  Frame frame;
  for (const std::size_t size : {0u, 8u, 15u, 17u, 71u, 100u}) EXPECT_FALSE(from_raw(raw, size, frame)) << size;
  raw.can_id = CAN_EFF_FLAG | 0x12345;
  EXPECT_FALSE(from_raw(raw, CAN_MTU, frame)) << "the extended format";
  raw.can_id = 1;
  raw.len = 200;
  ASSERT_TRUE(from_raw(raw, CAN_MTU, frame));
  EXPECT_EQ(frame.size, 8);
  ASSERT_TRUE(from_raw(raw, CANFD_MTU, frame));
  EXPECT_EQ(frame.size, 64);
}

TEST(BusErrors, ReportsTheMostSevere) {
  const auto reported = [](std::uint32_t id, std::uint8_t controller) {
    Frame frame{id, {0, controller, 0, 0, 0, 0, 0, 0}};
    frame.error = true;
    return bus_error_of(frame);
  };
  EXPECT_EQ(reported(CAN_ERR_BUSOFF | CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE), BusError::bus_off);
  EXPECT_EQ(reported(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_RX_WARNING), BusError::passive);
  EXPECT_EQ(reported(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW), BusError::overflow);
  EXPECT_EQ(reported(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING), BusError::warning);
  EXPECT_EQ(reported(CAN_ERR_CRTL, CAN_ERR_CRTL_ACTIVE), BusError::recovered);
  EXPECT_EQ(reported(CAN_ERR_ACK, 0), BusError::no_acknowledge);
  EXPECT_EQ(reported(CAN_ERR_CRTL | CAN_ERR_ACK, CAN_ERR_CRTL_TX_WARNING), BusError::no_acknowledge);
  EXPECT_EQ(reported(CAN_ERR_CRTL | CAN_ERR_PROT | CAN_ERR_TRX, CAN_ERR_CRTL_TX_WARNING), BusError::transceiver);
  EXPECT_EQ(reported(CAN_ERR_CRTL | CAN_ERR_PROT, CAN_ERR_CRTL_ACTIVE), BusError::protocol);
  EXPECT_EQ(reported(CAN_ERR_PROT | CAN_ERR_BUSERROR, 0), BusError::protocol);
  Frame at_acknowledge{CAN_ERR_PROT | CAN_ERR_BUSERROR, {0, 0, 0, CAN_ERR_PROT_LOC_ACK, 0, 0, 0, 0}};
  at_acknowledge.error = true;
  EXPECT_EQ(bus_error_of(at_acknowledge), BusError::no_acknowledge);
  EXPECT_EQ(reported(CAN_ERR_TRX, 0), BusError::transceiver);
  EXPECT_EQ(reported(CAN_ERR_RESTARTED, 0), BusError::recovered);
  EXPECT_EQ(reported(CAN_ERR_LOSTARB, 0), BusError::other);
  for (int i = 0; i <= static_cast<int>(BusError::other) + 1; ++i)
    EXPECT_NE(std::string(describe(static_cast<BusError>(i))), "");
}

}  // namespace
}  // namespace mrroc::can
