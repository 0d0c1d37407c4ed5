#include "command/number_option.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <optional>

#include "command/parse_command.hpp"

namespace mrroc::command {
namespace {

constexpr auto kLargest = std::numeric_limits<std::uint64_t>::max();

TEST(NumberOption, IntegerIsDecimalAndInRange) {
  for (const char* good : {"0", "16", "+5", "007", "18446744073709551615"})
    EXPECT_EQ(number_problem<std::uint64_t>(good, 0, kLargest), "") << good;
  for (const char* bad : {"-1", "-0", "", " 1", "1 ", "1.5", "1e3", "0x10", "soon", "18446744073709551616", "5abc",
                          "++5", "+", "-", "nan"})
    EXPECT_NE(number_problem<std::uint64_t>(bad, 0, kLargest), "") << bad;
  EXPECT_EQ(number_problem("15", 16, 8192), "'15', expected an integer from 16 to 8192");
  EXPECT_EQ(number_problem<std::uint64_t>("-1", 0, kLargest), "'-1', expected an integer of at least 0");
  EXPECT_NE(number_problem("99999999999999999999", 16, 8192), "");
}

TEST(NumberOption, RealNumberIsFiniteAndInRange) {
  for (const char* good : {"0.01", "60", "+.5", "1e1", "6e-2"}) EXPECT_EQ(number_problem(good, 0.01, 60.0), "") << good;
  for (const char* bad : {"0", "60.1", "nan", "inf", "-inf", "1e400", "0x1p3", "", "one", "1,5", "1.5s"})
    EXPECT_NE(number_problem(bad, 0.01, 60.0), "") << bad;
}

TEST(NumberOption, ErrorNamesOptionValueAndRange) {
  CLI::App app;
  std::optional<std::uint64_t> seed;
  add_number<std::uint64_t>(app, "--seed", seed, 0, 100, "of the random order");
  const auto parse = [&app](std::vector<std::string> words) {
    words = words_of(app, words);
    std::reverse(words.begin(), words.end());
    app.parse(std::move(words));
  };
  try {
    parse({"--seed", "-1"});
    FAIL() << "parsed";
  } catch (const CLI::ParseError& error) {
    EXPECT_STREQ(error.what(), "--seed: '-1', expected an integer from 0 to 100");
  }
  EXPECT_THROW(parse({"--seed=101"}), CLI::ParseError);
  EXPECT_THROW(parse({"--seed="}), CLI::ParseError);
  EXPECT_THROW(parse({"--seed", "1", "--seed", "2"}), CLI::ParseError);
  parse({"--seed", "100"});
  EXPECT_EQ(seed, 100U);
}

TEST(NumberOption, AcceptsExactlyTheNumbersOfTheRange) {
  EXPECT_TRUE(rc::check([](std::int64_t value, std::int64_t a, std::int64_t b) {
    const auto [min, max] = std::minmax(a, b);
    RC_ASSERT(number_problem(std::to_string(value), min, max).empty() == (value >= min && value <= max));
  }));
}

}  // namespace
}  // namespace mrroc::command
