#include "command/printable.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace mrroc::command {
namespace {

using namespace std::string_literals;

TEST(Printable, EscapesControlCharacters) {
  EXPECT_EQ(printable("\x1b[31mred"), "\\x1b[31mred");
  EXPECT_EQ(printable("a\rb\bc\x07"), "a\\x0db\\x08c\\x07");
  EXPECT_EQ(printable("zero\0end"s), "zero\\x00end");
  EXPECT_EQ(printable("del\x7f"), "del\\x7f");
  EXPECT_EQ(printable("csi\xc2\x9b"), "csi\\xc2\\x9b") << "C1, as UTF-8";
  EXPECT_EQ(printable("two\nlines"), "two\\x0alines");
}

TEST(Printable, EscapesInvalidUtf8) {
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "\\x9b31m")
      << "C1, as one byte";
  EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b") << "overlong";
  EXPECT_EQ(printable("\xe0\x80\x9b"), "\\xe0\\x80\\x9b") << "overlong";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a surrogate pair";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond U+10FFFF";
  EXPECT_EQ(printable("cut \xe2\x82"), "cut \\xe2\\x82");
  EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
}

TEST(Printable, EscapesBidirectionalControls) {
  EXPECT_EQ(printable("a\u202eb"), "a\\xe2\\x80\\xaeb");
  EXPECT_EQ(printable("a\u2066b"), "a\\xe2\\x81\\xa6b");
  EXPECT_EQ(printable("a\u2028b"), "a\\xe2\\x80\\xa8b");
}

TEST(Printable, KeepsText) {
  const std::string text = "Ramię \u017c\u00f3\u0142w 10 \u00b5m\t\u4e2d\u6587 \U0001F916 \\x1b 'quoted'";
  EXPECT_EQ(printable(text), text);
  EXPECT_EQ(printable_lines("one\ntwo\n"), "one\ntwo\n");
  EXPECT_EQ(printable_lines("one\r\n"), "one\\x0d\n");
}

TEST(Printable, NoControlBytesReachATerminal) {
  EXPECT_TRUE(rc::check([](const std::string& text) {
    const std::string shown = printable(text);
    RC_ASSERT(std::none_of(shown.begin(), shown.end(), [](char byte) {
      return (static_cast<unsigned char>(byte) < 0x20 && byte != '\t') || byte == 0x7f;
    }));
    RC_ASSERT(printable(shown) == shown);
  }));
}

}  // namespace
}  // namespace mrroc::command
