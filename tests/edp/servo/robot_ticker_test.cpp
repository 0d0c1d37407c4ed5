#include "edp/servo/robot_ticker.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <optional>

#include "clock/wall/monotonic.hpp"
#include "clock/wall/wait.hpp"

namespace mrroc::edp::robot_ticker_test {
namespace {

constexpr double kTickerPeriod = 0.001;
constexpr std::int64_t kNs = 1'000'000;

/// Gives the packages of a script, at once; where one is missing, the deadline comes.
class ScriptedClock final : public RobotClock {
 public:
  explicit ScriptedClock(double period = kTickerPeriod) : period_(period) {}
  double period() const noexcept override { return period_; }
  bool wait(std::int64_t deadline, Beat& beat) noexcept override {
    if (!script.empty() && script.front()) {
      beat = *script.front();
      script.pop_front();
      return true;
    }
    if (!script.empty()) script.pop_front();
    while (clock::monotonic_ns() < deadline) clock::pause(deadline - clock::monotonic_ns());
    ++deadlines;
    return false;
  }
  BeatCounters counters() const noexcept override { return {}; }

  std::deque<std::optional<Beat>> script;
  int deadlines = 0;

 private:
  double period_;
};

double place_of(const RobotTicker::Place& place) { return static_cast<double>(place.tick) + place.ahead; }

/// The package of the controller's n-th period, which begins `phase` of a period beside tick n.
Beat beat(std::int64_t epoch, double n, double phase = 0.25) {
  return {n * kTickerPeriod, epoch + std::llround((n + phase) * kNs)};
}

TEST(RobotTicker, TicksOnceForEachPackage) {
  const std::int64_t epoch = clock::monotonic_ns();
  ScriptedClock clock;
  for (int n = 0; n < 50; ++n) clock.script.emplace_back(beat(epoch, n));
  RobotTicker ticker(clock, epoch, kTickerPeriod);
  for (Tick n = 0; n < 50; ++n) {
    const RobotTicker::Place next = ticker.wait_next();
    EXPECT_EQ(next.tick, n);
    EXPECT_NEAR(next.ahead, 0.25, 1e-4);
  }
  EXPECT_EQ(ticker.statistics().ticks(), 50u);
  EXPECT_EQ(ticker.statistics().missed(), 0u);
  EXPECT_EQ(clock.deadlines, 0);
}

TEST(RobotTicker, CountsThePeriodsWithoutAPackageAsMissed) {
  const std::int64_t epoch = clock::monotonic_ns();
  ScriptedClock clock;
  for (const int n : {0, 1, 5, 6}) clock.script.emplace_back(beat(epoch, n));
  RobotTicker ticker(clock, epoch, kTickerPeriod);
  for (const Tick tick : {0, 1, 5, 6}) EXPECT_EQ(ticker.wait_next().tick, tick);
  EXPECT_EQ(ticker.statistics().missed(), 3u);
}

TEST(RobotTicker, AControllerWithALongPeriodMissesNothing) {
  const std::int64_t epoch = clock::monotonic_ns();
  ScriptedClock clock(4 * kTickerPeriod);
  for (int n = 0; n < 20; ++n) clock.script.emplace_back(beat(epoch, 4 * n));
  RobotTicker ticker(clock, epoch, kTickerPeriod);
  for (Tick n = 0; n < 20; ++n) EXPECT_EQ(ticker.wait_next().tick, 4 * n);
  EXPECT_EQ(ticker.statistics().missed(), 0u);
}

TEST(RobotTicker, TicksOnTheWallClockWhileTheRobotIsSilentAndContinuesWithIt) {
  const std::int64_t epoch = clock::monotonic_ns();
  ScriptedClock clock;
  for (int n = 0; n < 3; ++n) clock.script.emplace_back(beat(epoch, n));
  RobotTicker ticker(clock, epoch, kTickerPeriod);
  double last = -1;
  for (int i = 0; i < 10; ++i) {
    const double next = place_of(ticker.wait_next());
    EXPECT_GE(next, last + RobotTicker::kLeast);
    last = next;
  }
  EXPECT_GE(clock.deadlines, 7);
  // packages of the silence, which come late, are not ticked again
  for (double n = 3; n < last; ++n) clock.script.emplace_back(Beat{n * kTickerPeriod, clock::monotonic_ns()});
  const double next = std::ceil(last) + 2;
  clock.script.emplace_back(beat(epoch, next));
  const int deadlines = clock.deadlines;
  EXPECT_NEAR(place_of(ticker.wait_next()), next + 0.25, 0.05);
  EXPECT_EQ(clock.deadlines, deadlines);
  EXPECT_TRUE(clock.script.empty());
}

TEST(RobotTicker, NothingIsTickedBeforeTheEpoch) {
  const std::int64_t epoch = clock::monotonic_ns() + 20 * kNs;
  ScriptedClock clock;
  for (int n = -10; n < 2; ++n) clock.script.emplace_back(beat(epoch, n));
  RobotTicker ticker(clock, epoch, kTickerPeriod);
  EXPECT_EQ(ticker.wait_next().tick, 0u);
  EXPECT_EQ(ticker.wait_next().tick, 1u);
}

TEST(RobotTicker, ADoubledPackageIsTickedOnce) {
  const std::int64_t epoch = clock::monotonic_ns();
  ScriptedClock clock;
  for (const int n : {0, 1, 1, 2, 2, 2, 3}) clock.script.emplace_back(beat(epoch, n));
  RobotTicker ticker(clock, epoch, kTickerPeriod);
  for (Tick n = 0; n < 4; ++n) EXPECT_EQ(ticker.wait_next().tick, n);
}

}  // namespace
}  // namespace mrroc::edp::robot_ticker_test
