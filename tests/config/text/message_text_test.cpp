#include "config/text/message_text.hpp"

#include <gtest/gtest.h>

namespace mrroc::config::message_text_test {
namespace {

TEST(MessageText, NumbersAreShortest) {
  EXPECT_EQ(number_text(0.002), "0.002");
  EXPECT_EQ(number_text(-3), "-3");
  EXPECT_EQ(number_text(0.0005), "0.0005");
  EXPECT_EQ(number_text(12345.5), "12345.5");
  EXPECT_EQ(number_text(1e-9), "1e-09");
}

TEST(MessageText, QuotedTextStaysOnOneLineAndShort) {
  EXPECT_EQ(in_quotes("two\nlines\x7f"), "'two\\x0Alines\\x7F'");
  EXPECT_EQ(in_quotes(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(in_quotes(std::string(61, 'x')), "'" + std::string(60, 'x') + "...'");
  EXPECT_EQ(in_quotes(std::string(59, 'x') + "\xC3\xB3\xC5\x82"), "'" + std::string(59, 'x') + "...'");
}

TEST(MessageText, AlternativesReadAsASentence) {
  EXPECT_EQ(alternatives({}), "nothing");
  EXPECT_EQ(alternatives({"a"}), "'a'");
  EXPECT_EQ(alternatives({"a", "b"}), "'a' or 'b'");
  EXPECT_EQ(alternatives({"a", "b", "c"}), "'a', 'b' or 'c'");
}

}  // namespace
}  // namespace mrroc::config::message_text_test
