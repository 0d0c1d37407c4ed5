#include "canopen/emergency.hpp"

#include <gtest/gtest.h>

#include "canopen/random_frames.hpp"

namespace mrroc::canopen {
namespace {

TEST(Emergency, RoundTripsThroughItsFrame) {
  EXPECT_TRUE(rc::check("any", [](std::uint16_t code, std::uint8_t error_register, std::array<std::uint8_t, 5> own) {
    const Emergency sent{*rc::gen::inRange<NodeId>(1, kMaxNode + 1), code, error_register, own};
    const auto got = emergency_of(to_frame(sent));
    RC_ASSERT(got.has_value());
    RC_ASSERT(got->node == sent.node && got->code == code);
    RC_ASSERT(got->error_register == error_register && got->manufacturer == own);
  }));
}

TEST(Emergency, RejectsOtherFrames) {
  const can::Frame frame = to_frame({3, 0x7305, 1, {}});
  EXPECT_TRUE(emergency_of(frame));
  can::Frame other = frame;
  other.size = 7;
  EXPECT_FALSE(emergency_of(other));
  other = frame;
  other.fd = true;
  EXPECT_FALSE(emergency_of(other));
  other = frame;
  other.error = true;
  EXPECT_FALSE(emergency_of(other));
  other = frame;
  other.remote = true;
  EXPECT_FALSE(emergency_of(other));
  for (const std::uint32_t id : {0x080u, 0x100u, 0x183u, 0x07fu}) {
    other = frame;
    other.id = id;
    EXPECT_FALSE(emergency_of(other)) << id;
  }
}

TEST(Emergency, CodeHasItsTextOrThatOfItsGroup) {
  EXPECT_EQ(error_text(0x0000), "no error");
  EXPECT_EQ(error_text(0x7305), "incremental sensor 1 fault");
  EXPECT_EQ(error_text(0x2311), "continuous over-current");
  EXPECT_EQ(error_text(0x23ff), "current on the device's output side");
  EXPECT_EQ(error_text(0x2fff), "current");
  EXPECT_EQ(error_text(0x8611), "position following error");
  EXPECT_EQ(error_text(0xff01), "a manufacturer's error");
  EXPECT_EQ(error_text(0x0003), "no error") << "CiA 301, table 26: 00xxh";
  EXPECT_EQ(error_text(0x0100), "unknown error");
  EXPECT_EQ(error_text(0xa000), "unknown error");
  for (unsigned code = 0; code <= 0xffff; ++code) {
    const std::string_view text = error_text(static_cast<std::uint16_t>(code));
    EXPECT_FALSE(text.empty());
    if (code > 0xff) {
      EXPECT_NE(text, "no error") << code;
    }
  }
}

}  // namespace
}  // namespace mrroc::canopen
