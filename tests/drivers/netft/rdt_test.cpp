#include "drivers/netft/rdt.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>
#include <vector>

namespace mrroc::netft::rdt_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

Record any_record() {
  Record record{*rc::gen::arbitrary<std::uint32_t>(),
                *rc::gen::arbitrary<std::uint32_t>(),
                *rc::gen::arbitrary<std::uint32_t>(),
                {}};
  for (auto& count : record.counts) count = *rc::gen::arbitrary<std::int32_t>();
  return record;
}

TEST(Rdt, EncodesTheRequestsOfTheManual) {
  EXPECT_EQ(encode(Request{Command::start_realtime, 0}),
            (std::array<std::uint8_t, 8>{0x12, 0x34, 0x00, 0x02, 0, 0, 0, 0}));
  EXPECT_EQ(encode(Request{Command::set_bias, 0x01020304}),
            (std::array<std::uint8_t, 8>{0x12, 0x34, 0x00, 0x42, 1, 2, 3, 4}));
}

TEST(Rdt, DecodesARecordInNetworkByteOrder) {
  const Bytes packet{0,    0,    0,    7,    0,    1,    0,    0, 0x80, 2, 0, 0, 0, 0, 0,    1,    0xff, 0xff,
                     0xff, 0xff, 0x7f, 0xff, 0xff, 0xff, 0x80, 0, 0,    0, 0, 0, 1, 0, 0xff, 0xff, 0xff, 0};
  EXPECT_EQ(decode_record(packet), (Record{7, 0x10000, 0x80020000, {1, -1, 2147483647, -2147483648, 256, -256}}));
}

TEST(Rdt, ReadsWhatItWrites) {
  const bool ok = rc::check("requests and records round-trip", [] {
    const Request request{*rc::gen::element(Command::stop, Command::start_realtime, Command::start_buffered,
                                            Command::start_multi_unit, Command::reset_threshold, Command::set_bias),
                          *rc::gen::arbitrary<std::uint32_t>()};
    RC_ASSERT(decode_request(encode(request)) == request);
    const Record first = any_record(), second = any_record();
    Bytes packet;
    for (const Record& record : {first, second}) {
      const auto bytes = encode(record);
      packet.insert(packet.end(), bytes.begin(), bytes.end());
    }
    RC_ASSERT(records_in(packet.size()) == 2u);
    RC_ASSERT(decode_record(packet, 0) == first);
    RC_ASSERT(decode_record(packet, 1) == second);
  });
  EXPECT_TRUE(ok);
}

TEST(Rdt, RefusesRequestsOfAnotherForm) {
  const bool ok = rc::check("only whole requests with the header and a known command are requests", [] {
    const auto packet = *rc::gen::arbitrary<Bytes>();
    const auto request = decode_request(packet);
    if (!request) return;
    const auto again = encode(*request);
    RC_ASSERT(Bytes(again.begin(), again.end()) == packet);
  });
  EXPECT_TRUE(ok);
  const auto request = encode(Request{Command::start_realtime, 5});
  for (std::size_t size = 0; size < request.size(); ++size) {
    EXPECT_FALSE(decode_request(std::span(request).first(size))) << size;
  }
  EXPECT_FALSE(decode_request(Bytes{0x12, 0x34, 0, 2, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(decode_request(Bytes{0x12, 0x35, 0, 2, 0, 0, 0, 0}));
  EXPECT_FALSE(decode_request(Bytes{0x12, 0x34, 0, 1, 0, 0, 0, 0}));
}

TEST(Rdt, CountsOnlyWholeRecords) {
  EXPECT_EQ(records_in(0), 0u);
  EXPECT_EQ(records_in(35), 0u);
  EXPECT_EQ(records_in(36), 1u);
  EXPECT_EQ(records_in(37), 0u);
  EXPECT_EQ(records_in(40 * 36), 40u);
  EXPECT_EQ(records_in(41 * 36), 0u);
}

TEST(RdtStatus, NamesEveryBitOnce) {
  std::uint32_t all = 0;
  for (const StatusBit& bit : status_bits()) {
    EXPECT_EQ(all & bit.mask, 0u);
    all |= bit.mask;
    EXPECT_NE(std::string(status_text(bit.mask).view()).find(bit.name), std::string::npos) << bit.name;
  }
  EXPECT_EQ(all, 0xffff7ffeu) << "bits 15 and 0 are reserved";
}

TEST(RdtStatus, TextShowsTheWordAndItsBits) {
  EXPECT_EQ(status_text(0).view(), "0x00000000: healthy");
  EXPECT_EQ(status_text(0x80020000).view(), "0x80020000: transducer saturation or A/D error");
  EXPECT_EQ(status_text(0x80004004).view(), "0x80004004: watchdog timeout, internal temperature error");
  EXPECT_EQ(status_text(0x80000000).view(), "0x80000000: error");
  EXPECT_EQ(status_text(0x00008001).view(), "0x00008001: reserved bit 15, reserved bit 0");
  EXPECT_EQ(status_text(0xffffffff).view().substr(0, 12), "0xffffffff: ");
}

TEST(RdtStatus, OnlyAMonitorConditionLeavesTheCountsValid) {
  EXPECT_TRUE(is_valid(0));
  EXPECT_TRUE(is_valid(0x80010000));
  EXPECT_TRUE(is_valid(0x00010000));
  for (int i = 0; i < 32; ++i) {
    const std::uint32_t bit = std::uint32_t{1} << i;
    if (bit == kMonitorCondition) continue;
    EXPECT_FALSE(is_valid(bit)) << i;
    EXPECT_FALSE(is_valid(bit | kMonitorCondition) && bit != kErrorSummary) << i;
  }
}

}  // namespace
}  // namespace mrroc::netft::rdt_test
