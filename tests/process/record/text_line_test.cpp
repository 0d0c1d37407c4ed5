#include "process/record/text_line.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <string>

namespace mrroc::process::text_line_test {
namespace {

TEST(TextLine, NumbersReadBackExactly) {
  EXPECT_TRUE(rc::check([](double value) {
    TextLine line;
    line << value;
    const std::string text{line.view()};
    RC_ASSERT(std::strtod(text.c_str(), nullptr) == value);
  }));
}

TEST(TextLine, LongTextIsCutAndMarkedAsCut) {
  TextLine line;
  for (std::size_t i = 0; i < TextLine::kCapacity; ++i) line << "x";
  EXPECT_FALSE(line.cut());
  line << 1.5;
  EXPECT_TRUE(line.cut());
  EXPECT_EQ(line.view().size(), TextLine::kCapacity);
  line.clear();
  line << "again";
  EXPECT_EQ(line.view(), "again");
}

}  // namespace
}  // namespace mrroc::process::text_line_test
