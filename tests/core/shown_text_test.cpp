#include "core/shown_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace mrroc::core {
namespace {

TEST(Shown, KeepsVisibleCharacters) {
  for (const char* const text : {"", "axis 1", "a\\x1Bb", "\xC3\xB3\xC5\x82", "\xE2\x82\xAC", "\xF0\x9F\xA6\xBE"})
    EXPECT_EQ(shown(text), text);
}

TEST(Shown, EscapesInvisibleCharacters) {
  using namespace std::string_view_literals;
  EXPECT_EQ(shown("a\x1b[2Jb"), "a\\x1B[2Jb");
  EXPECT_EQ(shown("two\r\nlines\t"), "two\\x0D\\x0Alines\\x09");
  EXPECT_EQ(shown("\0\x7f"sv), "\\x00\\x7F");
  EXPECT_EQ(shown("\xEF\xBB\xBF#"), "U+FEFF#");
  EXPECT_EQ(shown("1\xC2\xA0"
                  "000"),
            "1U+00A0000");
  EXPECT_EQ(shown("\xC2\x9B"
                  "2J"),
            "U+009B2J");  // CSI of eight bits
  EXPECT_EQ(shown("\xE2\x80\xAE"
                  "lmx"),
            "U+202Elmx");  // right to left
  EXPECT_EQ(shown("\xA0\xFF\xFE"), "\\xA0\\xFF\\xFE");
  EXPECT_EQ(shown("\xC0\x80\xE0\x80\x80"), "\\xC0\\x80\\xE0\\x80\\x80");  // overlong
  EXPECT_EQ(shown("\xED\xA0\x80\xF4\x90\x80\x80"), "\\xED\\xA0\\x80\\xF4\\x90\\x80\\x80");
  EXPECT_EQ(shown("\xE2\x82"), "\\xE2\\x82");  // cut off
}

TEST(Shown, AnyBytesAreSafeOnATerminal) {
  EXPECT_TRUE(rc::check("any bytes", [](const std::string& bytes) {
    const std::string text = shown(bytes);
    RC_ASSERT(shown(text) == text);
    RC_ASSERT(std::none_of(text.begin(), text.end(),
                           [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }));
    RC_ASSERT(!odd_character(text));
  }));
}

TEST(OddCharacter, IsFoundWithItsColumnInCharacters) {
  EXPECT_FALSE(odd_character("0\t1 \xC5\x82"));
  EXPECT_EQ(odd_character("\xC5\x82"
                          "1\xC2\xA0")
                ->column,
            3u);
  EXPECT_EQ(odd_character("\xC5\x82"
                          "1\xC2\xA0")
                ->text,
            "U+00A0");
  EXPECT_EQ(odd_character("ab\xA0")->text, "\\xA0");
}

}  // namespace
}  // namespace mrroc::core
