#include "cli/run/watch/heartbeats.hpp"

#include <gtest/gtest.h>

namespace mrroc::cli::heartbeats_test {
namespace {

links::ProcessStatus status_of(const char* process, std::uint64_t beat) {
  links::ProcessStatus status;
  status.process = decltype(status.process)(process);
  status.beat = beat;
  return status;
}

/// The runner looks every 20 ms until `end`; the first silent process then, or empty.
std::string watch(Heartbeats& beats, double begin, double end) {
  for (double now = begin; now < end; now += 0.02)
    if (std::string name = beats.silent(now); !name.empty()) return name;
  return beats.silent(end);
}

TEST(Heartbeats, ProcessWithoutHeartbeatForTheTimeoutIsSilent) {
  Heartbeats beats(1);
  beats.expect({"arm", "mp"}, 10);
  EXPECT_EQ(watch(beats, 10, 10.99), "");
  EXPECT_TRUE(beats.take(status_of("mp", 1), 11));
  EXPECT_EQ(watch(beats, 11, 11.5), "arm") << "it has never sent a heartbeat";
  EXPECT_TRUE(beats.take(status_of("arm", 7), 11.5));
  EXPECT_EQ(beats.silent(11.5), "");
  EXPECT_EQ(watch(beats, 11.5, 12.25), "mp");
}

TEST(Heartbeats, RepeatedHeartbeatIsNoSignOfLife) {
  Heartbeats beats(1);
  beats.expect({"arm"}, 0);
  EXPECT_TRUE(beats.take(status_of("arm", 1), 0.5));
  EXPECT_EQ(watch(beats, 0.5, 1.4), "");
  EXPECT_FALSE(beats.take(status_of("arm", 1), 1.4)) << "DDS keeps the last sample for late readers";
  EXPECT_EQ(watch(beats, 1.4, 1.75), "arm");
}

/// A busy machine kept the runner from its turn: all processes would count as silent, and the first by name be blamed.
TEST(Heartbeats, TimeInWhichTheRunnerDidNotLookIsNoSilence) {
  Heartbeats beats(5);
  beats.expect({"arm", "mp"}, 100);
  double now = 107;  // before its first turn
  EXPECT_EQ(beats.silent(now), "");
  for (int turn = 1; turn <= 10; ++turn, now += 6) {
    EXPECT_TRUE(beats.take(status_of("arm", static_cast<std::uint64_t>(turn)), now));
    EXPECT_TRUE(beats.take(status_of("mp", static_cast<std::uint64_t>(turn)), now + 6)) << "between two statuses";
    now += 6;
    EXPECT_EQ(beats.silent(now + 6), "") << "between the statuses and the check, turn " << turn;
    now += 6;
  }
  EXPECT_TRUE(beats.take(status_of("mp", 11), now));
  int turns = 0;
  while (beats.silent(now).empty() && turns < 1000) {
    now += 2;  // slow turns
    EXPECT_EQ(beats.take(status_of("mp", static_cast<std::uint64_t>(12 + turns)), now), true);
    ++turns;
  }
  EXPECT_EQ(beats.silent(now), "arm");
  EXPECT_NEAR(turns, 5 / Heartbeats::kLongestPause, 2) << "a silent process is still reported";
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
}  // namespace mrroc::cli::heartbeats_test
