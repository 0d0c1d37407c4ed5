#include "mrroc/sensors/ultrasonic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "mrroc/conditions/elapsed_time.hpp"
#include "mrroc/errors.hpp"
#include "mrroc/move.hpp"
#include "sensors/played_task.hpp"
#include "sensors/ultrasonic/made_sensor.hpp"

namespace mrroc {
namespace {

/// An `Ultrasonic` whose hardware replays `lines`; non-interactive with `period`.
class UltrasonicTest : public ::testing::Test {
 protected:
  void play(const std::string& lines, Tick period) {
    task_ = std::make_unique<vsp::PlayedTask>(aggregating_, "ultrasonic", "# mrroc readings range\n" + lines, period);
    gate_ = std::make_unique<Ultrasonic>(*task_, "gate");
  }
  Ultrasonic& gate() { return *gate_; }

 private:
  vsp::UltrasonicSensor aggregating_ = vsp::made_sensor();
  std::unique_ptr<vsp::PlayedTask> task_;
  std::unique_ptr<Ultrasonic> gate_;
};

TEST_F(UltrasonicTest, DetectsNothingBeforeTheFirstReading) {
  play("0 1\n", 5);
  EXPECT_FALSE(gate().interactive());
  EXPECT_TRUE(std::isnan(gate().distance()));
  EXPECT_FALSE(gate().detected());
}

TEST_F(UltrasonicTest, WaitEndsWithTheFirstCloserPublishedReading) {
  play("0 -1\n 13 0.5\n 31 0.1\n 34 0.09\n", 25);
  const Outcome outcome = Wait({}, {gate()}, Closer{gate(), 0.10});
  EXPECT_EQ(outcome.end_tick, 50U);  // published at 0, 25, 50
  EXPECT_EQ(gate().distance(), 0.09);
  EXPECT_TRUE(gate().detected());
  EXPECT_TRUE(outcome.by("gate closer than 0.1 m"));
}

TEST_F(UltrasonicTest, MissingTargetIsNeverCloser) {
  play("0 -1\n 40 3\n", 0);
  const Outcome outcome = Wait({}, {gate()}, Closer{gate(), 100});
  EXPECT_EQ(outcome.end_tick, 40U);
}

TEST_F(UltrasonicTest, TargetInTheDeadZoneEndsTheWaitWithAnError) {
  play("0 -1\n 20 0.01\n", 10);
  EXPECT_THROW(Wait({}, {gate()}, Closer{gate(), 0.10}), NonFatalError);
  EXPECT_EQ(gate().reading().tick, 20U);
}

TEST_F(UltrasonicTest, CannotBeBiased) {
  play("0 1\n", 0);
  EXPECT_THROW(gate().bias(), NonFatalError);
}

TEST_F(UltrasonicTest, ConfiguredRangeHoldsFromTheNextReadingOn) {
  play("0 1.5\n 20 0.3\n", 0);
  Wait({}, {gate()}, Closer{gate(), 10});
  EXPECT_EQ(gate().distance(), 1.5);
  gate().configure(UltrasonicRange{0.1, 1.0});
  EXPECT_TRUE(std::isnan(gate().distance())) << "the reading of the configuration before is not kept";
  EXPECT_EQ(gate().configuration(), 1U);
  Wait({}, {gate()}, Closer{gate(), 0.5});
  EXPECT_EQ(gate().distance(), 0.3);
  EXPECT_EQ(gate().reading().configuration, 1U);
  gate().configure(UltrasonicRange{0.5, 1.0});
  EXPECT_THROW(Wait({}, {gate()}, Closer{gate(), 0.5}), NonFatalError) << "nearer than the nearest";
}

TEST_F(UltrasonicTest, RefusedRangeChangesNothing) {
  play("0 1.5\n", 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const UltrasonicRange& range : {UltrasonicRange{0.1, 5.0}, UltrasonicRange{0.001, 1.0},
                                       UltrasonicRange{1.0, 0.5}, UltrasonicRange{nan, 1}, UltrasonicRange{0.1, nan}})
    EXPECT_THROW(gate().configure(range), NonFatalError) << range.nearest << " " << range.farthest;
  EXPECT_EQ(gate().configuration(), 0U);
  Wait({}, {gate()}, Closer{gate(), 2});
  EXPECT_EQ(gate().distance(), 1.5);
}

TEST_F(UltrasonicTest, PublishedReadingOfTheOldConfigurationIsNotTaken) {
  play("0 0.9\n", 25);
  Wait({}, {gate()}, Closer{gate(), 1});
  ASSERT_EQ(gate().reading().tick, 0U);
  gate().configure(UltrasonicRange{0.1, 0.5});
  EXPECT_TRUE(std::isnan(gate().distance()));
  Wait({}, {gate()}, ElapsedTime{gate().task(), 0.2});
  EXPECT_EQ(gate().reading().configuration, 1U);
  EXPECT_FALSE(gate().detected());
  EXPECT_EQ(gate().distance(), 0.5) << "beyond the configured range";
}

TEST_F(UltrasonicTest, CloserRefusesInvalidDistances) {
  play("0 1\n", 0);
  EXPECT_THROW(Closer(gate(), 0), NonFatalError);
  EXPECT_THROW(Closer(gate(), -1), NonFatalError);
  EXPECT_THROW(Closer(gate(), std::numeric_limits<double>::quiet_NaN()), NonFatalError);
}

}  // namespace
}  // namespace mrroc
