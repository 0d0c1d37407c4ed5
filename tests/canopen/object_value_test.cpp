#include "canopen/object_value.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "can/frame.hpp"
#include "canopen/random_frames.hpp"

namespace mrroc::canopen {
namespace {

std::string text(std::vector<std::uint8_t> value, DataType type) {
  return to_text(std::span<const std::uint8_t>(value), type);
}

TEST(ObjectValue, LimitsOfItsType) {
  EXPECT_EQ(least(DataType::integer8), -128);
  EXPECT_EQ(greatest(DataType::integer8), 127);
  EXPECT_EQ(least(DataType::integer16), -32768);
  EXPECT_EQ(greatest(DataType::integer32), 2147483647);
  EXPECT_EQ(least(DataType::integer64), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(greatest(DataType::integer64), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(least(DataType::unsigned16), 0);
  EXPECT_EQ(greatest(DataType::unsigned8), 255);
  EXPECT_EQ(greatest(DataType::unsigned32), 4294967295);
  EXPECT_EQ(greatest(DataType::unsigned64), std::numeric_limits<std::int64_t>::max())
      << "the largest representable value";
  EXPECT_EQ(greatest(DataType::boolean), 1);
  for (const DataType type : {DataType::real32, DataType::visible_string, DataType::domain, DataType{0x99}}) {
    EXPECT_EQ(least(type), 0);
    EXPECT_EQ(greatest(type), 0);
  }
}

TEST(ObjectValue, ReadableText) {
  EXPECT_EQ(to_text(Object{0x6041}), "6041h:0");
  EXPECT_EQ(to_text(Object{0x1018, 255}), "1018h:255");
  EXPECT_EQ(text({0xff}, DataType::integer8), "-1");
  EXPECT_EQ(text({0xff}, DataType::unsigned8), "255");
  EXPECT_EQ(text({0x00, 0x00, 0x00, 0x80}, DataType::integer32), "-2147483648");
  EXPECT_EQ(text({'d', '1', 0x0a, 0xff}, DataType::visible_string), "\"d1??\"");
  EXPECT_EQ(text({1, 2}, DataType::unsigned32), "01 02") << "not the size of the type";
  EXPECT_EQ(text({0xab, 0x01}, DataType::octet_string), "ab 01");
  EXPECT_EQ(text({}, DataType::octet_string), "");
}

TEST(ObjectValue, RoundTripsThroughItsBytes) {
  EXPECT_TRUE(rc::check("little-endian, with sign", [](std::uint64_t raw) {
    for (const DataType type : {DataType::integer8, DataType::integer16, DataType::integer32, DataType::integer64}) {
      const std::int64_t value = can::sign_extended(raw, size_of(type));
      RC_ASSERT(value >= least(type) && value <= greatest(type));
      std::vector<std::uint8_t> bytes(size_of(type));
      can::put(bytes, 0, bytes.size(), static_cast<std::uint64_t>(value));
      RC_ASSERT(text(bytes, type) == std::to_string(value));
    }
  }));
}

}  // namespace
}  // namespace mrroc::canopen
