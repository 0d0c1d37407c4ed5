#include "cli/operator/terminal/line_editor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace mrroc::cli::line_editor_test {
namespace {

TEST(LineEditor, LinesEndWithReturnAndSpaceIsAKeyOnAnEmptyLine) {
  LineEditor editor;
  EXPECT_EQ(editor.feed("pau"), "");
  EXPECT_EQ(editor.text(), "pau");
  EXPECT_EQ(editor.feed("se\rres"), "pause\n");
  EXPECT_EQ(editor.feed("ume \n"), "resume \n");
  EXPECT_EQ(editor.feed(" "), " \n");
  EXPECT_EQ(editor.feed("a b\n"), "a b\n");
}

TEST(LineEditor, KeysEdit) {
  LineEditor editor;
  editor.feed("ab\x7f");
  EXPECT_EQ(editor.text(), "a");
  editor.feed("\xc5\xbc\x08");  // one character of two bytes
  EXPECT_EQ(editor.text(), "a");
  editor.feed(" bcd\x17");
  EXPECT_EQ(editor.text(), "a ");
  editor.feed("x\x15");
  EXPECT_EQ(editor.text(), "");
  editor.feed("\x7f\x17");
  EXPECT_EQ(editor.text(), "");
}

TEST(LineEditor, TabCompletesOneVerbAndTheUpArrowBringsTheLastLine) {
  LineEditor editor;
  editor.feed("pa\t");
  EXPECT_EQ(editor.text(), "pause");
  EXPECT_EQ(editor.feed("\r"), "pause\n");
  editor.feed("st\t");
  EXPECT_EQ(editor.text(), "st") << "status, start and stop";
  editor.feed(
      "\x15"
      "an\t");
  EXPECT_EQ(editor.text(), "answer ");
  editor.feed("\x1b[A");
  EXPECT_EQ(editor.text(), "pause");
  editor.feed("\x1b[1;5C\x1bOB\x1b[200~");
  EXPECT_EQ(editor.text(), "pause") << "other keys do nothing";
}

TEST(LineEditor, AnyBytesGiveLinesWithoutControlCharacters) {
  EXPECT_TRUE(rc::check([](const std::string& bytes) {
    LineEditor editor;
    const std::string lines = editor.feed(bytes);
    for (const char byte : lines + editor.text()) RC_ASSERT(byte == '\n' || static_cast<unsigned char>(byte) >= 0x20);
    RC_ASSERT(editor.text().size() <= LineEditor::kMaxLine);
  }));
}

}  // namespace
}  // namespace mrroc::cli::line_editor_test
