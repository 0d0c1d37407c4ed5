#include "sensors/ultrasonic/ultrasonic_sensor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "allocations.hpp"
#include "mrroc/errors.hpp"
#include "sensors/ultrasonic/made_sensor.hpp"

namespace mrroc::vsp {
namespace {

/// The defaults: max_range 4 m, dead_zone 0.02 m.
void expect_nothing_seen(const SensorReading& v) {
  EXPECT_EQ(v.error.error_class, ErrorClass::none);
  EXPECT_EQ(v.values[0], 4.0);
  EXPECT_EQ(v.values[1], 0);
}

TEST(UltrasonicSensor, MeasuresFromDeadZoneToMaxRangeInclusive) {
  UltrasonicSensor sensor = made_sensor();
  for (const double range : {0.02, 0.1, 1.5, 4.0}) {
    const SensorReading v = aggregated(sensor, range);
    EXPECT_EQ(v.error.error_class, ErrorClass::none);
    EXPECT_EQ(v.values[0], range);
    EXPECT_EQ(v.values[1], 1);
  }
}

TEST(UltrasonicSensor, ReportsMaxRangeAndNotDetectedWithoutATarget) {
  UltrasonicSensor sensor = made_sensor();
  expect_nothing_seen(aggregated(sensor, -1));
  expect_nothing_seen(aggregated(sensor, 4.0000001));
  expect_nothing_seen(aggregated(sensor, 1e6));
}

TEST(UltrasonicSensor, ReadingInTheDeadZoneIsAnErrorAndTheNextIsNot) {
  UltrasonicSensor sensor = made_sensor();
  for (const double range : {0.0, 0.0199}) {
    const SensorReading v = aggregated(sensor, range);
    EXPECT_EQ(v.error.error_class, ErrorClass::non_fatal);
    EXPECT_EQ(v.error.code, ErrorCode::sensor_out_of_range);
    EXPECT_TRUE(std::isnan(v.values[0]));
    EXPECT_EQ(aggregated(sensor, 0.5).values[0], 0.5);
  }
}

TEST(UltrasonicSensor, NegativeRangeIsAHardwareError) {
  UltrasonicSensor sensor = made_sensor();
  const SensorReading v = aggregated(sensor, -0.5);
  EXPECT_EQ(v.error.error_class, ErrorClass::hardware);
  EXPECT_EQ(v.error.code, ErrorCode::sensor_hardware);
  EXPECT_EQ(v.error.detail.view(), "range -0.5 m, expected at least 0 or -1");
}

TEST(UltrasonicSensor, NoiseHasTheStatedDeviationAndDependsOnNameAndTickOnly) {
  UltrasonicSensor sensor = made_sensor("noise = 0.01"), same = made_sensor("noise = 0.01");
  UltrasonicSensor other = made_sensor("noise = 0.01", "door");
  constexpr int kSamples = 20000;
  double sum = 0, squares = 0;
  int different = 0;
  for (Tick tick = 0; tick < kSamples; ++tick) {
    const double error = aggregated(sensor, 1.0, tick).values[0] - 1.0;
    sum += error;
    squares += error * error;
    if (aggregated(other, 1.0, tick).values[0] - 1.0 != error) ++different;
  }
  EXPECT_NEAR(std::sqrt(squares / kSamples), 0.01, 0.0002);
  EXPECT_NEAR(sum / kSamples, 0, 0.0003);
  EXPECT_GT(different, kSamples - 10);
  EXPECT_EQ(aggregated(sensor, 1.0, 123).values, aggregated(same, 1.0, 123).values);
}

TEST(UltrasonicSensor, LosesEchoesWithTheStatedProbability) {
  UltrasonicSensor sensor = made_sensor("dropout = 0.2"), same = made_sensor("dropout = 0.2");
  constexpr int kSamples = 20000;
  int lost = 0;
  for (Tick tick = 0; tick < kSamples; ++tick) {
    const SensorReading v = aggregated(sensor, 1.0, tick);
    EXPECT_EQ(v.values, aggregated(same, 1.0, tick).values);
    if (v.values[1] == 0) {
      ++lost;
      expect_nothing_seen(v);
    }
  }
  EXPECT_NEAR(lost / double{kSamples}, 0.2, 0.01);
  UltrasonicSensor deaf = made_sensor("dropout = 1.0");
  for (Tick tick = 0; tick < 100; ++tick) expect_nothing_seen(aggregated(deaf, 1.0, tick));
}

TEST(UltrasonicSensor, EveryReadingWithoutAnErrorIsWithinTheRange) {
  EXPECT_TRUE(rc::check([] {
    UltrasonicSensor sensor = made_sensor("max_range = 2.0\ndead_zone = 0.1\nnoise = 0.5\ndropout = 0.1");
    for (Tick tick = 0; tick < 100; ++tick) {
      const double range = 0.01 * *rc::gen::inRange(-100, 300);
      const SensorReading v = aggregated(sensor, range < 0 ? -1 : range, tick);
      if (v.error.error_class != ErrorClass::none) continue;
      RC_ASSERT(v.values[0] >= 0.1);
      RC_ASSERT(v.values[0] <= 2.0);
      RC_ASSERT(v.values[1] == 1 || (v.values[1] == 0 && v.values[0] == 2.0));
    }
  }));
}

TEST(UltrasonicSensor, HasNoZeroAndRefusesADeadZoneBeyondItsRange) {
  EXPECT_FALSE(made_sensor().bias(RawReading{}));
  EXPECT_THROW(made_sensor("max_range = 1.0\ndead_zone = 1.0"), SystemError);
}

TEST(UltrasonicSensor, DoesNotAllocateAfterItsConfiguration) {
  UltrasonicSensor sensor = made_sensor("noise = 0.01\ndropout = 0.1");
  const std::size_t before = test::thread_allocations();
  int errors = 0;
  for (const double range : {-1.0, -0.5, 0.0, 1.0, 5.0}) {
    if (aggregated(sensor, range, 3).error.error_class != ErrorClass::none) ++errors;
  }
  EXPECT_EQ(test::thread_allocations() - before, 0U);
  EXPECT_EQ(errors, 2);
}

}  // namespace
}  // namespace mrroc::vsp
