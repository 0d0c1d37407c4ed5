#include "clock/wall/peer_clock.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

namespace mrroc::clock::peer_clock_test {
namespace {

/// One round trip to a peer whose clock is `offset` ahead, with these durations there and back.
RoundTrip trip(std::int64_t sent, std::int64_t offset, std::int64_t there, std::int64_t held, std::int64_t back) {
  return {sent, sent + there + held + back, sent + there + held + offset, held};
}

RC_GTEST_PROP(PeerClock, ErrorNeverExceedsItsBound, (std::int32_t raw_offset)) {
  const std::int64_t offset = std::int64_t{raw_offset} * 1'000'000;
  PeerClock clock;
  std::int64_t now = 1'000'000;
  for (int i = 0; i < 3 * PeerClock::kWindow; ++i) {
    const auto there = *rc::gen::inRange<std::int64_t>(0, 5'000'000);
    const auto back = *rc::gen::inRange<std::int64_t>(0, 5'000'000);
    const auto held = *rc::gen::inRange<std::int64_t>(0, 5'000'000);
    clock.add(trip(now, offset, there, held, back));
    now += 5'000'000;
  }
  RC_ASSERT(clock.offset().has_value());
  RC_ASSERT(std::abs(clock.offset()->ns - offset) <= clock.offset()->error_ns);
}

TEST(PeerClock, HasNoEstimateBeforeAWindowIsFull) {
  PeerClock clock;
  for (int i = 0; i < PeerClock::kWindow - 1; ++i) clock.add(trip(i, 7, 10, 0, 10));
  EXPECT_FALSE(clock.offset());
  clock.add(trip(0, 7, 10, 0, 10));
  ASSERT_TRUE(clock.offset());
  EXPECT_EQ(clock.offset()->ns, 7);
  EXPECT_EQ(clock.offset()->error_ns, 10);
}

TEST(PeerClock, TheShortestTripOfAWindowCounts) {
  PeerClock clock;
  for (int i = 0; i < PeerClock::kWindow; ++i) clock.add(i == 17 ? trip(i, 500, 20, 5, 20) : trip(i, 500, 3000, 5, 20));
  EXPECT_EQ(clock.offset()->ns, 500);
  EXPECT_EQ(clock.offset()->error_ns, 20);
}

TEST(PeerClock, IgnoresImpossibleTrips) {
  PeerClock clock;
  for (int i = 0; i < 2 * PeerClock::kWindow; ++i) clock.add({100, 150, 0, 60});  // held for longer than it took
  EXPECT_FALSE(clock.offset());
}

TEST(PeerClock, LaterWindowMayOnlyImproveTheOffset) {
  PeerClock clock;
  for (const std::int64_t way : {100, 10, 50})
    for (int i = 0; i < PeerClock::kWindow; ++i) clock.add(trip(i, way, way, 0, way));
  EXPECT_EQ(clock.offset()->error_ns, 10);
  EXPECT_EQ(clock.offset()->ns, 10);
}

/// Processes may take 15 s to be ready: the first offset is then out of date.
TEST(PeerClock, OldOffsetIsReplaced) {
  PeerClock clock;
  const auto window = [&clock](std::int64_t at, std::int64_t offset, std::int64_t way) {
    for (int i = 0; i < PeerClock::kWindow; ++i) clock.add(trip(at, offset, way, 0, way));
  };
  window(0, 0, 50'000);
  window(1'000'000'000, 50'000, 200'000);  // it may have moved by 100 us, but is still known better
  EXPECT_EQ(clock.offset()->error_ns, 50'000);
  window(15'000'000'000, 1'500'000, 200'000);
  EXPECT_EQ(clock.offset()->ns, 1'500'000);
  EXPECT_EQ(clock.offset()->error_ns, 200'000);
  clock.keep();
  window(16'000'000'000, 1'500'000, 200'000);
  EXPECT_EQ(clock.worst_drift_ns(), 0);
}

TEST(PeerClock, DriftIsCertainBeyondBothErrorsOnly) {
  PeerClock clock;
  const auto window = [&clock](std::int64_t offset, std::int64_t way) {
    for (int i = 0; i < PeerClock::kWindow; ++i) clock.add(trip(i, offset, way, 0, way));
  };
  window(1000, 10);
  clock.keep();
  EXPECT_EQ(clock.worst_drift_ns(), 0);
  window(1030, 25);
  EXPECT_EQ(clock.worst_drift_ns(), 30);
  EXPECT_EQ(clock.certain_drift_ns(), 0) << "30 apart, but with errors of 10 and 25";
  window(940, 15);
  EXPECT_EQ(clock.worst_drift_ns(), 60);
  EXPECT_EQ(clock.certain_drift_ns(), 35);
  window(1000, 10);
  EXPECT_EQ(clock.certain_drift_ns(), 35) << "the worst value is kept";
  EXPECT_EQ(clock.offset()->ns, 1000);
}

}  // namespace
}  // namespace mrroc::clock::peer_clock_test
