#include "core/text_lines.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace mrroc::core {
namespace {

using namespace std::string_view_literals;
using Lines = std::vector<std::string>;

Lines lines_of(std::string_view text) {
  Lines all;
  for (TextLines lines(text); lines.next();) all.emplace_back(lines.line());
  return all;
}

std::string mistake(std::string_view text) {
  try {
    lines_of(text);
    return "";
  } catch (const TextError& error) {
    return std::to_string(error.line) + ": " + error.what();
  }
}

TEST(TextLines, IgnoreByteOrderMarkAndLineEnds) {
  const Lines plain{"a 1", "", " b"};
  EXPECT_EQ(lines_of("a 1\n\n b\n"), plain);
  EXPECT_EQ(lines_of("a 1\n\n b"), plain) << "no line end at the end";
  EXPECT_EQ(lines_of("a 1\r\n\r\n b\r\n"), plain);
  EXPECT_EQ(lines_of("a 1\n\r\n b\r\n"), plain) << "mixed";
  EXPECT_EQ(lines_of("a 1\r\r\n\n b\r"), plain) << "converted twice";
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                     "a 1\n\n b\n"),
            plain);
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                     "a 1\r\n\r\n b\r\n\x1A"),
            plain);
  EXPECT_EQ(lines_of(""), Lines{});
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"), Lines{""});
  EXPECT_EQ(lines_of("a\n\xEF\xBB\xBF"
                     "b"),
            (Lines{"a",
                   "\xEF\xBB\xBF"
                   "b"}))
      << "a mark inside is part of the text";
}

TEST(TextLines, RefusesBinaryData) {
  EXPECT_EQ(mistake("\xFF\xFE"
                    "a\0"sv),
            "1: the file is in UTF-16, expected UTF-8 (choose it when the file is saved)");
  EXPECT_EQ(mistake("\xFE\xFF\0a"sv), "1: the file is in UTF-16, expected UTF-8 (choose it when the file is saved)");
  EXPECT_EQ(mistake("a\0b\0\n\0"sv), "1: the file is in UTF-16, expected UTF-8 (choose it when the file is saved)");
  EXPECT_EQ(mistake("\0a\0b\0\n"sv), "1: the file is in UTF-16, expected UTF-8 (choose it when the file is saved)");
  EXPECT_EQ(mistake("\xFF\xFE\0\0a\0\0\0"sv),
            "1: the file is in UTF-32, expected UTF-8 (choose it when the file is saved)");
  EXPECT_EQ(mistake("a\nb\xC5\x82\0c\n"sv), "2: a byte \\x00 at column 3, expected text");
  EXPECT_EQ(mistake("a\rb\rc\r"), "1: a carriage return (\\x0D) at column 2, expected lines that end with LF or CRLF");
  EXPECT_EQ(mistake("a\n" + std::string(kLongestLine + 1, 'x')), "2: a line of 10001 bytes, expected at most 10000");
  EXPECT_EQ(mistake(std::string(kLongestLine, 'x') + "\n"), "");
}

TEST(TextLines, ReadsTextWithAnyLineEnds) {
  EXPECT_TRUE(rc::check("any lines", [] {
    const auto letters = rc::gen::container<std::string>(rc::gen::element<char>('a', '1', ' ', '\t', ',', '#', '\xC5'));
    const auto written = *rc::gen::container<Lines>(letters);
    std::string text = *rc::gen::element<std::string>("", "\xEF\xBB\xBF");
    for (const std::string& line : written) text += line + *rc::gen::element<std::string>("\n", "\r\n");
    if (text == "\xEF\xBB\xBF") return;
    RC_ASSERT(lines_of(text) == written);
  }));
}

TEST(Trimmed, RemovesCommentAndBlanks) {
  EXPECT_EQ(trimmed(" \ta b\t "), "a b");
  EXPECT_EQ(trimmed(" \t"), "");
  EXPECT_EQ(without_comment("1 2 # why", '#'), "1 2 ");
  EXPECT_EQ(without_comment("# why", '#'), "");
  EXPECT_EQ(without_comment("a#b", '#'), "a#b");
  EXPECT_EQ(without_comment("a;b ;c", ';'), "a;b ");
  EXPECT_EQ(words_of("\t1  2\t3 "), (std::vector<std::string_view>{"1", "2", "3"}));
  EXPECT_TRUE(words_of(" ").empty());
}

TEST(Cells, SplitLikeASpreadsheet) {
  using Cells = std::vector<std::string_view>;
  EXPECT_EQ(cells_of("1, 2 ,\t3", ','), (Cells{"1", "2", "3"}));
  EXPECT_EQ(cells_of("1,,3", ','), (Cells{"1", "", "3"}));
  EXPECT_EQ(cells_of("1,2,3,", ','), (Cells{"1", "2", "3"}));
  EXPECT_EQ(cells_of("1,2,,,", ','), (Cells{"1", "2"}));
  EXPECT_EQ(cells_of(";;;", ';'), Cells{});
  EXPECT_EQ(cells_of("\"a\", \" b \" ,\"", ','), (Cells{"a", "b", "\""}));
}

}  // namespace
}  // namespace mrroc::core
