#include "cli/hosts/line_channel.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/socket.h>

#include <algorithm>
#include <memory>

namespace mrroc::cli::line_channel_test {
namespace {

using Lines = std::vector<std::string>;

struct Pair {
  Pair() {
    int ends[2] = {-1, -1};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    a = std::make_unique<LineChannel>(ends[0], ends[0]);
    b = std::make_unique<LineChannel>(ends[1], ends[1]);
  }
  std::unique_ptr<LineChannel> a, b;
};

RC_GTEST_PROP(LineChannel, TransmitsLinesUnchanged, (std::vector<std::string> lines)) {
  Pair pair;
  for (std::string& line : lines) {
    std::replace(line.begin(), line.end(), '\n', ' ');
    pair.a->write(line);
  }
  RC_ASSERT(pair.b->read() == lines);
  RC_ASSERT(!pair.b->closed());
}

TEST(LineChannel, PeerThatDoesNotReadDoesNotBlock) {
  Pair pair;
  const std::string line(1000, 'x');
  constexpr std::size_t kLines = 5000;
  for (std::size_t i = 0; i < kLines; ++i) pair.a->write(line);
  EXPECT_GT(pair.a->waiting(), 0U);
  Lines read;
  while (read.size() < kLines) {
    const Lines more = pair.b->read();
    ASSERT_FALSE(more.empty());
    read.insert(read.end(), more.begin(), more.end());
    pair.a->flush();
  }
  EXPECT_EQ(pair.a->waiting(), 0U);
  for (const std::string& each : read) ASSERT_EQ(each, line);
}

TEST(LineChannel, WaitingLinesKeepTheirOrder) {
  Pair pair;
  std::size_t written = 0;
  std::size_t read = 0;
  const auto line = [](std::size_t number) { return std::to_string(number) + std::string(number % 3000, 'x'); };
  for (int round = 0; round < 200; ++round) {
    for (int i = 0; i < 20; ++i) pair.a->write(line(written++));
    for (const std::string& each : pair.b->read()) ASSERT_EQ(each, line(read++));
  }
  while (read < written) {
    pair.a->flush();
    for (const std::string& each : pair.b->read()) ASSERT_EQ(each, line(read++));
  }
  EXPECT_EQ(pair.a->waiting(), 0U);
}

TEST(LineChannel, IgnoresALineBreakWithinALine) {
  Pair pair;
  pair.a->write("one\ntwo");
  EXPECT_EQ(pair.b->read(), (Lines{"one two"}));
}

TEST(LineChannel, DetectsTheEndOfThePeer) {
  Pair pair;
  pair.a->write("last");
  pair.a->finish();
  EXPECT_EQ(pair.b->read(), (Lines{"last"}));
  EXPECT_TRUE(pair.b->closed());
  pair.b->write("still received");
  EXPECT_EQ(pair.a->read(), (Lines{"still received"}));
  pair.b.reset();
  EXPECT_EQ(pair.a->read(), (Lines{}));
  EXPECT_TRUE(pair.a->closed());
}

}  // namespace
}  // namespace mrroc::cli::line_channel_test
