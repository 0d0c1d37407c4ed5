#include "cli/panel/panel_access.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cli/panel/beat.hpp"
#include "cli/panel/outbox.hpp"

namespace mrroc::cli::panel_access_test {
namespace {

/// The token in a URL.
std::string token_of(const std::string& url) {
  const std::size_t end = url.rfind('/');
  const std::size_t begin = url.rfind('/', end - 1) + 1;
  return url.substr(begin, end - begin);
}

class PanelAccessTest : public testing::Test {
 protected:
  PanelAccessTest() { access.listen_at(8080); }
  PanelAccess access{"127.0.0.1", false};
};

TEST_F(PanelAccessTest, TokensAreRandomAndDifferent) {
  const std::string command = token_of(access.url(PanelRight::command)),
                    watch = token_of(access.url(PanelRight::watch));
  EXPECT_EQ(command.size(), 32U);
  EXPECT_EQ(watch.size(), 32U);
  EXPECT_NE(command, watch);
  EXPECT_NE(command, token_of(PanelAccess("127.0.0.1", false).url(PanelRight::command)));
  EXPECT_EQ(access.url(PanelRight::watch), "http://127.0.0.1:8080/" + watch + "/");
}

TEST_F(PanelAccessTest, OnlyAWholeTokenGivesARight) {
  const std::string command = token_of(access.url(PanelRight::command)),
                    watch = token_of(access.url(PanelRight::watch));
  EXPECT_EQ(access.right_of(command), PanelRight::command);
  EXPECT_EQ(access.right_of(watch), PanelRight::watch);
  for (const std::string& wrong : {std::string{}, command.substr(1), command.substr(0, 31), command + "0",
                                   std::string(32, '0'), command.substr(0, 16) + watch.substr(16)})
    EXPECT_EQ(access.right_of(wrong), PanelRight::none) << wrong;
  std::string upper = command;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  EXPECT_EQ(access.right_of(upper), upper == command ? PanelRight::command : PanelRight::none);
}

TEST_F(PanelAccessTest, OriginIsThatOfTheOwnPage) {
  for (const char* own : {"http://127.0.0.1:8080", "http://localhost:8080"})
    EXPECT_TRUE(access.is_own_origin(own)) << own;
  for (const char* foreign :
       {"http://127.0.0.1:8081", "https://127.0.0.1:8080", "http://127.0.0.1", "http://127.0.0.1:8080.evil.example",
        "http://evil.example", "http://evil.example:8080", "null", "", "http://", "http://127.0.0.1:8080/"})
    EXPECT_FALSE(access.is_own_origin(foreign)) << foreign;
  EXPECT_FALSE(access.is_own_origin(nullptr));
}

TEST_F(PanelAccessTest, HostIsTheOwnAddress) {
  EXPECT_TRUE(access.is_own_host("127.0.0.1:8080"));
  for (const char* foreign : {"127.0.0.1", "evil.example:8080", "127.0.0.1:80", ""})
    EXPECT_FALSE(access.is_own_host(foreign)) << foreign;
  PanelAccess other("10.0.0.2", true);
  other.listen_at(443);
  EXPECT_TRUE(other.is_own_origin("https://10.0.0.2:443"));
  EXPECT_FALSE(other.is_own_host("localhost:443")) << "another machine's name for itself";
}

TEST(OutboxTest, LinesKeepTheirOrderAndStatesAreTheNewest) {
  Outbox outbox;
  outbox.replace("robot/arm", "old");
  outbox.add("1");
  outbox.replace("robot/arm", "new");
  outbox.replace("beat", "b");
  outbox.add("2");
  EXPECT_EQ(outbox.take(), (std::vector<std::string>{"1", "2", "b", "new"}));
  EXPECT_TRUE(outbox.take().empty());
}

TEST(OutboxTest, MemoryIsBounded) {
  Outbox outbox;
  const std::string line(1000, 'x');
  for (std::size_t i = 0; i < 10 * Outbox::kMaxBytes / line.size(); ++i) {
    outbox.add(line);
    outbox.replace("state", line);
  }
  EXPECT_TRUE(outbox.overflowed());
  EXPECT_LE(outbox.take().size() * line.size(), Outbox::kMaxBytes + line.size());
  EXPECT_TRUE(outbox.overflowed()) << "what was lost stays lost";
}

TEST(BeatTest, OldAndFutureNumbersAreNotRecent) {
  const Beat beat;
  EXPECT_TRUE(beat.is_recent(beat.now()));
  EXPECT_FALSE(beat.is_recent(beat.now() - Beat::kMaxAge - 1));
  EXPECT_FALSE(beat.is_recent(beat.now() + 1000));
}

}  // namespace
}  // namespace mrroc::cli::panel_access_test
