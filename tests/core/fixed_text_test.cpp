#include "mrroc/fixed_text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "mrroc/robot_state.hpp"

namespace mrroc {
namespace {

// original's defect 17: messages to the operator were composed in 256 bytes with strcpy and strcat
TEST(FixedText, LongerTextIsCutAndNothingBehindItIsTouched) {
  struct {
    FixedText<8> text;
    char behind = 'b';
  } record;
  for (std::size_t size = 0; size < 1000; ++size) {
    const std::string text(size, 'x');
    record.text.assign(text);
    ASSERT_EQ(record.text.view(), text.substr(0, 8));
    ASSERT_EQ(record.text.c_str()[record.text.view().size()], '\0');
    ASSERT_EQ(record.behind, 'b');
  }
  record.text.assign("short");
  EXPECT_EQ(record.text, FixedText<8>("short")) << "the rest of the longer text is gone";
}

TEST(FixedText, ReportAcceptsADetailOfAnyLength) {
  ErrorReport report;
  report.detail.assign(std::string(5000, 'y'));
  EXPECT_EQ(report.detail.view().size(), 191u);
}

}  // namespace
}  // namespace mrroc
