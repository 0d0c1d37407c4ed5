#include "mrroc/sensors/time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "mrroc/errors.hpp"
#include "mrroc/move.hpp"
#include "sensors/played_task.hpp"
#include "sensors/time/made_sensor.hpp"

namespace mrroc {
namespace {

/// A replay of the clock: a line for each of the first 200 ticks. The servo period is 2 ms.
std::string ticks() {
  std::string lines = "# mrroc readings tick\n";
  for (int tick = 0; tick < 200; ++tick) {
    lines += std::to_string(tick);
    lines += " ";
    lines += std::to_string(tick);
    lines += "\n";
  }
  return lines;
}

class TimeTest : public ::testing::Test {
 protected:
  void play(Tick period = 0) {
    task_ = std::make_unique<vsp::PlayedTask>(aggregating_, "time", ticks(), period);
    clock_ = std::make_unique<Time>(*task_, "clock");
  }
  Time& watch() { return *clock_; }

 private:
  vsp::TimeSensor aggregating_ = vsp::made_sensor();
  std::unique_ptr<vsp::PlayedTask> task_;
  std::unique_ptr<Time> clock_;
};

TEST_F(TimeTest, HasNoValueBeforeTheFirstReading) {
  play();
  EXPECT_TRUE(std::isnan(watch().time()));
  EXPECT_EQ(watch().tick(), 0U);
}

TEST_F(TimeTest, WaitEndsAtTheFirstStepAfterTheTime) {
  play();
  // a step without robots is 10 ticks, 0.02 s; 0.14 and 0.06 are not finite binary fractions
  const Outcome outcome = Wait({}, {watch()}, TimeReached{watch(), 0.14});
  EXPECT_EQ(outcome.end_tick, 70U);
  EXPECT_EQ(watch().tick(), 70U);
  EXPECT_DOUBLE_EQ(watch().time(), 0.14);
  EXPECT_TRUE(outcome.by("clock reached 0.14 s"));
  EXPECT_EQ(Wait({}, {watch()}, TimeReached{watch(), 0.1401}).end_tick, 80U);
}

TEST_F(TimeTest, PassedTimeEndsTheWaitAtOnce) {
  play();
  Wait({}, {watch()}, TimeReached{watch(), 0.1});
  EXPECT_EQ(Wait({}, {watch()}, TimeReached{watch(), 0.02}).steps, 0U);
}

TEST_F(TimeTest, BiasStartsTheStopWatch) {
  play();
  Wait({}, {watch()}, TimeReached{watch(), 0.1});
  watch().bias();
  EXPECT_EQ(watch().time(), 0);
  const Outcome lap = Wait({}, {watch()}, TimeReached{watch(), 0.06});
  EXPECT_EQ(lap.end_tick, 80U);
  EXPECT_EQ(watch().tick(), 80U);
}

TEST_F(TimeTest, PublishedTimeIsThatOfItsReading) {
  play(25);
  EXPECT_EQ(Wait({}, {watch()}, TimeReached{watch(), 0.06}).end_tick, 50U);  // published at 0, 25, 50
}

TEST_F(TimeTest, TimeReachedRefusesInvalidTimes) {
  play();
  EXPECT_THROW(TimeReached(watch(), std::numeric_limits<double>::quiet_NaN()), NonFatalError);
  EXPECT_THROW(TimeReached(watch(), std::numeric_limits<double>::infinity()), NonFatalError);
}

}  // namespace
}  // namespace mrroc
