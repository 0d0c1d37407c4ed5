#include "drivers/ur/rtde/recipe.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "allocations.hpp"
#include "drivers/ur/rtde/packet.hpp"

namespace mrroc::ur::rtde::recipe_test {
namespace {

/// A value of any type, every bit pattern of its bytes.
Value any_value(FieldType type) {
  std::array<std::uint8_t, 48> bytes{};
  for (std::uint8_t& byte : bytes) byte = *rc::gen::arbitrary<std::uint8_t>();
  WireReader reader(bytes);
  return take_value(reader, type);
}

struct Package {
  Recipe recipe;
  std::vector<Value> values;
  std::vector<std::uint8_t> bytes;
};

Package any_package() {
  Package package;
  package.recipe.id = *rc::gen::arbitrary<std::uint8_t>();
  const auto count = *rc::gen::inRange<std::size_t>(0, 20);
  for (std::size_t i = 0; i < count; ++i) {
    package.recipe.types.push_back(static_cast<FieldType>(*rc::gen::inRange<std::size_t>(0, kFieldTypes)));
    package.values.push_back(any_value(package.recipe.types.back()));
  }
  package.bytes.resize(kMaxPacket);
  package.bytes.resize(encode_data(package.recipe, package.values, package.bytes));
  return package;
}

Bytes payload_of(const Package& package) { return Bytes(package.bytes).subspan(kHeaderSize); }

RC_GTEST_PROP(DataPackage, RoundTrips, ()) {
  const Package package = any_package();
  RC_ASSERT(package.bytes.size() == kHeaderSize + package.recipe.size());
  std::vector<Value> values(package.values.size());
  RC_ASSERT(decode_data(package.recipe, payload_of(package), values));
  std::vector<std::uint8_t> again(package.bytes.size());
  RC_ASSERT(encode_data(package.recipe, values, again) == package.bytes.size());
  RC_ASSERT(again == package.bytes);  // bytes, because a NaN differs from itself
}

RC_GTEST_PROP(DataPackage, EveryOtherLengthIsRefused, ()) {
  Package package = any_package();
  std::vector<Value> values(package.values.size());
  for (std::size_t size = 0; size < payload_of(package).size(); ++size)
    RC_ASSERT(!decode_data(package.recipe, payload_of(package).first(size), values));
  package.bytes.push_back(0);
  RC_ASSERT(!decode_data(package.recipe, payload_of(package), values));
}

RC_GTEST_PROP(DataPackage, AnotherRecipeIsRefused, ()) {
  const Package package = any_package();
  std::vector<Value> values(package.values.size());
  Recipe other = package.recipe;
  ++other.id;
  RC_ASSERT(!decode_data(other, payload_of(package), values));
  values.emplace_back();
  RC_ASSERT(!decode_data(package.recipe, payload_of(package), values));
}

RC_GTEST_PROP(DataPackage, IsNotWrittenIntoTooLittleMemory, ()) {
  const Package package = any_package();
  std::vector<std::uint8_t> memory(package.bytes.size() - 1);
  RC_ASSERT(encode_data(package.recipe, package.values, memory) == 0u);
}

TEST(DataPackage, ValuesOfAnotherTypeAreNotWritten) {
  const Recipe recipe{1, {FieldType::real}};
  std::array<std::uint8_t, 64> memory{};
  EXPECT_EQ(encode_data(recipe, std::array<Value, 1>{std::int32_t{1}}, memory), 0u);
  EXPECT_EQ(encode_data(recipe, std::array<Value, 1>{1.0}, memory), 12u);
}

TEST(DataPackage, IsBigEndian) {
  const Recipe recipe{7, {FieldType::uint32, FieldType::real, FieldType::boolean}};
  std::array<std::uint8_t, 64> memory{};
  const std::array<Value, 3> values{std::uint32_t{0x01020304}, 1.0, true};
  ASSERT_EQ(encode_data(recipe, values, memory), 17u);
  const std::array<std::uint8_t, 17> expected{0, 17, 'U', 7, 1, 2, 3, 4, 0x3f, 0xf0, 0, 0, 0, 0, 0, 0, 1};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), memory.begin()));
}

TEST(DataPackage, AllocatesNothing) {
  const Recipe recipe{1, {FieldType::real, FieldType::vector6d, FieldType::vector6_int32, FieldType::uint64}};
  const std::vector<Value> values{1.0, Vector6d{1, 2}, Vector6Int32{3}, std::uint64_t{4}};
  std::vector<Value> read(values.size());
  std::array<std::uint8_t, 256> memory{};
  {
    const test::Counting counting;
    const std::size_t size = encode_data(recipe, values, memory);
    ASSERT_TRUE(decode_data(recipe, Bytes(memory).subspan(kHeaderSize, size - kHeaderSize), read));
  }
  EXPECT_EQ(test::Counting::counted(), 0u);
  EXPECT_EQ(read, values);
}

TEST(FieldType, NamesAreThoseOfTheGuide) {
  for (std::size_t i = 0; i < kFieldTypes; ++i) {
    const auto type = static_cast<FieldType>(i);
    EXPECT_EQ(field_type(name_of(type)), type);
    EXPECT_EQ(type_of(zero_of(type)), type);
  }
  EXPECT_EQ(field_type("VECTOR6D"), FieldType::vector6d);
  EXPECT_EQ(field_type("NOT_FOUND"), std::nullopt);
  EXPECT_EQ(size_of(FieldType::vector6_int32), 24u);
}

TEST(NameList, MayEndWithAComma) {
  EXPECT_EQ(split_names("a,b,"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(split_names("a,b"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(split_names("a,,b"), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_TRUE(split_names("").empty());
  EXPECT_EQ(join_names(split_names("a,b,")), "a,b");
}

}  // namespace
}  // namespace mrroc::ur::rtde::recipe_test
