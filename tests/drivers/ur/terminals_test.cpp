#include "drivers/ur/terminals.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace mrroc::ur::terminals_test {
namespace {

TEST(Terminals, WithoutNumbersTheToolsAreNotSeen) {
  EXPECT_EQ(as_numbered(0x3ffff, kNoToolTerminals), 0xffff);
  EXPECT_EQ(as_reported(0xffff, kNoToolTerminals), 0xffffu);
  EXPECT_EQ(terminal_fields(kNoToolTerminals).size(), 8u);
  EXPECT_EQ(terminal_fields(3).size(), 10u);
}

TEST(Terminals, EachNumberHasOneTerminal) {
  EXPECT_TRUE(rc::check([] {
    const int tool = *rc::gen::inRange(0, 15);
    const auto numbered = *rc::gen::arbitrary<std::uint16_t>();
    const std::uint64_t reported = as_reported(numbered, tool);
    RC_ASSERT(as_numbered(reported, tool) == numbered);
    RC_ASSERT(reported >> 18 == 0u);
    RC_ASSERT((reported & tool_mask(tool)) == 0u);
    RC_ASSERT((reported >> 16) == (numbered >> tool & 3u));
  }));
}

TEST(Terminals, OnlyThoseThatHaveNumbersAreWritten) {
  EXPECT_TRUE(rc::check([] {
    const int tool = *rc::gen::inRange(-1, 15);
    ControllerIo outputs;
    outputs.digital = *rc::gen::arbitrary<std::uint16_t>();
    std::vector<rtde::Value> values(terminal_fields(tool).size());
    write_terminals(outputs, tool, values);
    const auto byte = [&](std::size_t i) { return unsigned{std::get<std::uint8_t>(values[i])}; };
    unsigned mask = byte(0) | byte(2) << 8, bits = byte(1) | byte(3) << 8;
    if (tool >= 0) {
      mask |= byte(8) << 16;
      bits |= byte(9) << 16;
    }
    RC_ASSERT(mask == as_reported(0xffff, tool));
    RC_ASSERT(bits == as_reported(outputs.digital, tool));
  }));
}

}  // namespace
}  // namespace mrroc::ur::terminals_test
