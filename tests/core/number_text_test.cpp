#include "core/number_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

namespace mrroc::core {
namespace {

std::string printed(const char* format, double value) {
  char text[512];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

double any_finite() {
  return std::bit_cast<double>(*rc::gen::suchThat(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
    return std::isfinite(std::bit_cast<double>(bits));
  }));
}

TEST(ToDouble, ReadsEveryPrintedDoubleBackExactly) {
  EXPECT_TRUE(rc::check("all bit patterns", [] {
    const double value = any_finite();
    for (const char* const format : {"%.17g", "%.17e", "%.20G", "%+.17g", "%a"}) {
      const std::string text = printed(format, value);
      const auto back = to_double(text);
      if (std::string_view(format) == "%a") {
        RC_ASSERT(!back);  // hexadecimal floating point is not a decimal number
      } else {
        RC_ASSERT(back.has_value());
        RC_ASSERT(std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(value));
      }
    }
    char shortest[64];
    const auto end = std::to_chars(shortest, shortest + sizeof shortest, value).ptr;
    RC_ASSERT(to_double({shortest, end}) == value);
  }));
}

TEST(ToDouble, AcceptsTheUsualSpellings) {
  EXPECT_EQ(to_double("+0.5"), 0.5);
  EXPECT_EQ(to_double("1."), 1);
  EXPECT_EQ(to_double(".5"), 0.5);
  EXPECT_EQ(to_double("1.e-3"), 1e-3);
  EXPECT_EQ(to_double("1E+3"), 1e3);
  EXPECT_EQ(to_double("-0"), 0);
  EXPECT_EQ(to_double("007"), 7);
  EXPECT_EQ(to_double("INF"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(to_double("-Infinity"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(to_double("NaN").value()));
  EXPECT_EQ(to_double("1e-400"), 0);
  EXPECT_EQ(to_double("-0.0000001e-99999999999999999999"), 0);
  EXPECT_EQ(to_double("4.9e-324"), std::numeric_limits<double>::denorm_min());
}

TEST(ToDouble, RefusesEverythingElse) {
  for (const char* const text : {"",
                                 "+",
                                 "-",
                                 ".",
                                 "+-1",
                                 "-+1",
                                 "++1",
                                 "+ 1",
                                 " 1",
                                 "1 ",
                                 "1\t",
                                 "1,5",
                                 "1.5.2",
                                 "0x10",
                                 "1e",
                                 "e5",
                                 "1e5.5",
                                 "1f",
                                 "1_000",
                                 "1'000",
                                 "nan(5)",
                                 "infi",
                                 "1e999",
                                 "-1e400",
                                 "99999e9999999999999999",
                                 "\xC2\xA0"
                                 "1",
                                 "\xEF\xBB\xBF"
                                 "1",
                                 "\xD9\xA1"})
    EXPECT_FALSE(to_double(text)) << text;
  EXPECT_TRUE(is_too_large("1e999"));
  EXPECT_TRUE(is_too_large("-12345e308"));
  for (const char* const text : {"1e-999", "1", "inf", "x", ""}) EXPECT_FALSE(is_too_large(text)) << text;
  for (const char* const text : {"inf", "-inf", "nan", "x"}) EXPECT_FALSE(to_finite(text)) << text;
}

TEST(ToWhole, ReadsExactlyTheNumbersOfItsType) {
  EXPECT_TRUE(rc::check("round trip", [](std::int64_t value) {
    RC_ASSERT(to_whole<std::int64_t>(std::to_string(value)) == value);
    if (value >= 0) RC_ASSERT(to_whole<std::int64_t>("+" + std::to_string(value)) == value);
    RC_ASSERT(to_whole<std::uint64_t>(std::to_string(value)).has_value() == (value >= 0));
  }));
  for (const char* const text : {"", "+", "-", "+-1", "1.0", "1e3", "0x1", " 1", "1 ", "18446744073709551616"})
    EXPECT_FALSE(to_whole<std::uint64_t>(text)) << text;
}

TEST(ToLiteral, ReadsDecimalHexadecimalAndOctal) {
  EXPECT_TRUE(rc::check("round trip", [](std::uint64_t value) {
    char text[64];
    for (const char* const format : {"%llu", "+%llu", "0x%llx", "0X%llX", "0%llo"}) {
      std::snprintf(text, sizeof text, format, static_cast<unsigned long long>(value));
      RC_ASSERT(to_literal(text) == value);
    }
    std::snprintf(text, sizeof text, "-0x%llx", static_cast<unsigned long long>(value));
    RC_ASSERT(to_literal(text) == 0 - value);
  }));
  EXPECT_EQ(to_literal("0"), 0u);
  EXPECT_EQ(to_literal("010"), 8u);
  for (const char* const text : {"", "0x", "-", "0180", "089", "0x 1", "0xg", "1h", "180h", "0x1FFFFFFFFFFFFFFFF",
                                 "0b1", "1.0", "--1", "0x-1", "$10"})
    EXPECT_FALSE(to_literal(text)) << text;
}

TEST(NumberProblem, NamesInvisibleCharacters) {
  EXPECT_EQ(number_problem(""), "is empty");
  EXPECT_EQ(number_problem("0,5"), "has a decimal comma");
  EXPECT_EQ(number_problem("-1,5e3"), "has a decimal comma");
  EXPECT_EQ(number_problem("1,000,000"), "is not a number");
  EXPECT_EQ(number_problem("1\xC2\xA0"
                           "5"),
            "has U+00A0 at character 2");
  EXPECT_EQ(number_problem("1.5\xA0"), "has \\xA0 at character 4");
  EXPECT_EQ(number_problem("\xE2\x88\x92"
                           "5"),
            "is not a number");  // a visible minus sign
  EXPECT_EQ(number_problem("5\x1b[2J"), "has \\x1B at character 2");
  EXPECT_EQ(number_problem("fast"), "is not a number");
}

}  // namespace
}  // namespace mrroc::core
