#include <gtest/gtest.h>

#include <filesystem>

#include "config/message_of.hpp"
#include "config/table.hpp"
#include "mrroc/testing/scratch_folder.hpp"

namespace mrroc::config::table_syntax_test {
namespace {

namespace fs = std::filesystem;

class TableSyntaxTest : public testing::Test {
 protected:
  std::string message(std::string_view text) {
    const auto file = scratch_.write("t.toml", text);
    return message_of(scratch_.path(), [&] { Table::load(file); });
  }

  std::string file_message(const fs::path& file) {
    return message_of(scratch_.path(), [&] { Table::load(file); });
  }

  task_test::ScratchFolder scratch_;
};

TEST_F(TableSyntaxTest, SyntaxErrorsNameLineAndColumn) {
  const auto begins = [this](std::string_view text) { return message(text).substr(0, 19); };
  EXPECT_EQ(begins("a = 1\nb = = 2\n"), "t.toml:2: column 5:");
  EXPECT_EQ(begins("a = 1\n\n[robots\n"), "t.toml:3: column 8:");
  EXPECT_TRUE(message("a = 'open\n").starts_with("t.toml:1: column 10:"));
  EXPECT_TRUE(message("a = 1\na = 2\n").starts_with("t.toml:2: column "));
  EXPECT_TRUE(message("[a]\n[b]\n[a]\n").starts_with("t.toml:3: column "));
  EXPECT_TRUE(message("a = 1\nb = 0x\n").starts_with("t.toml:2: column "));
  EXPECT_TRUE(message("a = 1\nb = [1,\n2\n").ends_with(", expected valid TOML"));
}

TEST_F(TableSyntaxTest, NonAsciiCharacterIsRefusedBehindANumberAndAcceptedInAMultilineText) {
  // undefined behaviour in toml++ 3.3, which the sanitizer reports
  for (const char* character : {"\u00a7", "\u00e9", "\u2010", "\ufdff"}) {
    EXPECT_TRUE(message(std::string{"a = 1\nb = 1e-320"} + character).starts_with("t.toml:2: column "));
    const auto file = scratch_.write("t.toml", std::string{"a = \"\"\"\\\n"} + character + "\"\"\"\n");
    EXPECT_EQ(Table::load(file).text("a"), character);
  }
}

TEST_F(TableSyntaxTest, NamesTheFileAsGiven) {
  const fs::path file = "no/such/file.toml";
  EXPECT_EQ(file_message(file), "no/such/file.toml: does not exist, expected a readable file");
}

TEST_F(TableSyntaxTest, RefusesUnreadableFiles) {
  EXPECT_EQ(file_message(scratch_.path() / "."), ".: is a directory, expected a readable file");
  EXPECT_EQ(file_message(fs::path("/dev/null")), "/dev/null: is not a regular file, expected a readable file");
  fs::create_symlink("nowhere", scratch_.path() / "broken");
  EXPECT_EQ(file_message(scratch_.path() / "broken"), "broken: does not exist, expected a readable file");
  // a file that root can open but not read
  EXPECT_EQ(file_message(fs::path("/proc/self/mem")),
            "/proc/self/mem: cannot be read: Input/output error, expected a readable file");
}

TEST_F(TableSyntaxTest, ByteThatOldEditorsEndAFileWithIsNotPartOfIt) {
  for (const std::string text : {"a = 1\n\x1A", "a = 1\x1A", "a = 1\r\n\x1A"})
    EXPECT_EQ(Table::load(scratch_.write("t.toml", text)).integer("a", 0, 9), 1) << text;
  EXPECT_TRUE(message("a = 1\x1A\nb = 2\n").starts_with("t.toml:1: "));
}

TEST_F(TableSyntaxTest, EmptyFileIsAnEmptyTable) {
  const auto file = scratch_.write("t.toml", "");
  EXPECT_TRUE(Table::load(file).keys().empty());
  EXPECT_TRUE(Table::load(scratch_.write("t.toml", "\xEF\xBB\xBF# only a comment")).keys().empty());
}

TEST_F(TableSyntaxTest, RefusesABinaryFile) {
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 37 + 129);
  EXPECT_TRUE(message(bytes).starts_with("t.toml:2: a byte \\x00 at column 47,")) << message(bytes);
  const std::string nothing(4096, '\0');
  EXPECT_TRUE(message(nothing).starts_with("t.toml:1: a byte \\x00 at column 1,")) << message(nothing);
}

TEST_F(TableSyntaxTest, ReadsAFileOfAMegabyte) {
  std::string text;
  int keys = 0;
  for (; text.size() < 1'000'000; ++keys) text += "key_" + std::to_string(keys) + " = " + std::to_string(keys) + "\n";
  const Table table = Table::load(scratch_.write("t.toml", text));
  EXPECT_EQ(table.keys().size(), static_cast<std::size_t>(keys));
  EXPECT_EQ(table.integer("key_12345", 0, keys), 12345);
  EXPECT_EQ(table.line("key_12345"), 12346);
}

TEST_F(TableSyntaxTest, RefusesAMegabyteInOneLine) {
  std::string dots = "a = 1\n[a";
  while (dots.size() < 1'000'000) dots += ".a";
  EXPECT_TRUE(message(dots + "]\n").starts_with("t.toml:2: a line of ")) << message(dots + "]\n");
  std::string brackets(9'000, '[');
  EXPECT_TRUE(message("a = " + brackets).starts_with("t.toml:1: column "));
}

TEST_F(TableSyntaxTest, ReadsDeepDottedKeysToTheLimitOfALine) {
  std::string deep = "[a";
  while (deep.size() < 9'990) deep += ".a";
  EXPECT_EQ(message(deep + "]\nx = 1\n"), "");
}

}  // namespace
}  // namespace mrroc::config::table_syntax_test
