#include "cli/run/heartbeats.hpp"

#include <gtest/gtest.h>

namespace mrroc::cli {
namespace {

links::ProcessStatus status_of(const char* process, std::uint64_t beat) {
  links::ProcessStatus status;
  status.process = decltype(status.process)(process);
  status.beat = beat;
  return status;
}

TEST(Heartbeats, ProcessWithoutHeartbeatForTheTimeoutIsSilent) {
  Heartbeats beats(1);
  beats.expect({"arm", "mp"}, 10);
  EXPECT_EQ(beats.silent(11), "");
  EXPECT_TRUE(beats.take(status_of("mp", 1), 11));
  EXPECT_EQ(beats.silent(11.5), "arm") << "it has never sent a heartbeat";
  EXPECT_TRUE(beats.take(status_of("arm", 7), 11.5));
  EXPECT_EQ(beats.silent(11.5), "");
  EXPECT_EQ(beats.silent(12.25), "mp");
}

TEST(Heartbeats, RepeatedHeartbeatIsNoSignOfLife) {
  Heartbeats beats(1);
  beats.expect({"arm"}, 0);
  EXPECT_TRUE(beats.take(status_of("arm", 1), 0.5));
  EXPECT_FALSE(beats.take(status_of("arm", 1), 1.5)) << "DDS keeps the last sample for late readers";
  EXPECT_EQ(beats.silent(1.75), "arm");
}

TEST(Heartbeats, NamesTheProcessesThatHaveNotReported) {
  Heartbeats beats(1);
  EXPECT_EQ(beats.missing({"arm", "sim"}), (std::vector<std::string>{"arm", "sim"}));
  beats.take(status_of("arm", 1), 0);
  EXPECT_EQ(beats.missing({"arm", "sim"}), (std::vector<std::string>{"sim"}));
  beats.take(status_of("sim", 1), 0);
  EXPECT_EQ(beats.missing({"arm", "sim"}), (std::vector<std::string>{}));
}

TEST(Heartbeats, UnexpectedProcessMayBeSilent) {
  Heartbeats beats(1);
  beats.expect({"arm"}, 0);
  EXPECT_TRUE(beats.take(status_of("wrist", 1), 0));
  EXPECT_TRUE(beats.take(status_of("arm", 1), 5));
  EXPECT_EQ(beats.silent(5.5), "");
  EXPECT_EQ(beats.statuses().size(), 2U);
}

}  // namespace
}  // namespace mrroc::cli
