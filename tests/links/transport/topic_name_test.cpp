#include "links/transport/topic_name.hpp"

#include <gtest/gtest.h>

#include "mrroc/errors.hpp"

namespace mrroc::links {
namespace {

std::string complaint(const std::string& topic) {
  try {
    check_topic_name(topic);
  } catch (const SystemError& error) {
    EXPECT_EQ(error.code(), ErrorCode::configuration);
    return error.detail();
  }
  return "none";
}

TEST(TopicName, AcceptsNamesThatDdsAccepts) {
  EXPECT_EQ(topic_name("press/arm", "command"), "press/arm/command");
  EXPECT_EQ(complaint("_a/B_9/c"), "none");
  EXPECT_EQ(complaint(std::string(95, 'x')), "none");
}

TEST(TopicName, ReportsInvalidNames) {
  EXPECT_EQ(complaint(""), "topic name '': must not be empty");
  EXPECT_EQ(complaint("3robot"), "topic name '3robot': must begin with a letter or '_'");
  EXPECT_EQ(complaint("robot-3"), "topic name 'robot-3': has '-'; expected letters, digits, '_' and '/'");
  EXPECT_EQ(complaint("a b"), "topic name 'a b': has ' '; expected letters, digits, '_' and '/'");
  EXPECT_EQ(complaint("a//b"), "topic name 'a//b': a part between '/' is empty");
  EXPECT_EQ(complaint("a/"), "topic name 'a/': a part between '/' is empty");
  EXPECT_NE(complaint(std::string(96, 'x')).find("longer than 95 characters"), std::string::npos);
}

}  // namespace
}  // namespace mrroc::links
