#include "core/nearest_word.hpp"

#include <gtest/gtest.h>

namespace mrroc::core {
namespace {

TEST(NearestWord, EditDistanceCountsTypingErrors) {
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("abc", "abc"), 0u);
  EXPECT_EQ(edit_distance("hardware", "hardwear"), 2u);
  EXPECT_EQ(edit_distance("tpye", "type"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(NearestWord, IsEmptyWhenNothingIsNear) {
  EXPECT_EQ(nearest_word("hardwear", {"host", "hardware"}), "hardware");
  EXPECT_EQ(nearest_word("xyz", {"host", "hardware"}), "");
  EXPECT_EQ(nearest_word("b", {"a"}), "");  // one letter replaced is another key
  EXPECT_EQ(nearest_word("a", {}), "");
}

}  // namespace
}  // namespace mrroc::core
