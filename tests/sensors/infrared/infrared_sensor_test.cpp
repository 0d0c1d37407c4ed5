#include "sensors/infrared/infrared_sensor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "allocations.hpp"
#include "mrroc/errors.hpp"
#include "sensors/infrared/made_sensor.hpp"

namespace mrroc::vsp {
namespace {

/// The defaults: max_range 0.8 m, dead_zone 0.1 m.
void expect_nothing_seen(const SensorReading& v) {
  EXPECT_EQ(v.error.error_class, ErrorClass::none);
  EXPECT_EQ(v.values[0], 0.8);
  EXPECT_EQ(v.values[1], 0);
  EXPECT_EQ(v.values[2], 0);
}

/// Mean and standard deviation of the readings at `range`, minus `range`.
std::pair<double, double> errors_at(const std::string& toml, double range) {
  InfraredSensor sensor = made_sensor(toml);
  constexpr int kSamples = 20000;
  double sum = 0, squares = 0;
  for (Tick tick = 0; tick < kSamples; ++tick) {
    const double error = aggregated(sensor, range, tick).values[0] - range;
    sum += error;
    squares += error * error;
  }
  return {sum / kSamples, std::sqrt(squares / kSamples)};
}

TEST(InfraredSensor, MeasuresFromDeadZoneToMaxRangeInclusive) {
  InfraredSensor sensor = made_sensor();
  for (const double range : {0.1, 0.25, 0.8}) {
    const SensorReading v = aggregated(sensor, range);
    EXPECT_EQ(v.error.error_class, ErrorClass::none);
    EXPECT_EQ(v.values[0], range);
    EXPECT_EQ(v.values[1], 1);
  }
}

TEST(InfraredSensor, ReportsMaxRangeAndNotDetectedWithoutATarget) {
  InfraredSensor sensor = made_sensor();
  aggregated(sensor, 0.2);
  expect_nothing_seen(aggregated(sensor, -1));
  expect_nothing_seen(aggregated(sensor, 0.8000001));
}

TEST(InfraredSensor, ReadingInTheDeadZoneIsAnErrorWithoutAValueAndTheNextIsNot) {
  InfraredSensor sensor = made_sensor();
  for (const double range : {0.0, 0.05, 0.0999}) {
    const SensorReading v = aggregated(sensor, range);
    EXPECT_EQ(v.error.error_class, ErrorClass::non_fatal);
    EXPECT_EQ(v.error.code, ErrorCode::sensor_out_of_range);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(v.values[i]));
    EXPECT_EQ(aggregated(sensor, 0.5).values[0], 0.5);
  }
  EXPECT_EQ(aggregated(sensor, 0.05).error.detail.view(), "range 0.05 m, expected at least 0.1 m, the dead zone");
}

TEST(InfraredSensor, NegativeRangeIsAHardwareError) {
  InfraredSensor sensor = made_sensor();
  const SensorReading v = aggregated(sensor, -0.5);
  EXPECT_EQ(v.error.error_class, ErrorClass::hardware);
  EXPECT_EQ(v.error.code, ErrorCode::sensor_hardware);
}

TEST(InfraredSensor, NoiseGrowsWithTheSquareOfTheDistance) {
  for (const double range : {0.2, 0.4, 0.6}) {
    const double expected = 0.02 * range * range;
    const auto [mean, deviation] = errors_at("noise = 0.02", range);
    EXPECT_NEAR(deviation, expected, 0.02 * expected) << range;
    EXPECT_NEAR(mean, 0, 0.03 * expected) << range;
  }
}

TEST(InfraredSensor, NoiseAndLossesDependOnNameAndTickOnly) {
  const char* const kNoisy = "noise = 0.1\ndropout = 0.2";
  InfraredSensor one = made_sensor(kNoisy), same = made_sensor(kNoisy), other = made_sensor(kNoisy, "door");
  int different = 0;
  for (Tick tick = 200; tick > 0; --tick) {
    const SensorReading a = aggregated(one, 0.5, tick);
    EXPECT_EQ(a.values, aggregated(same, 0.5, tick).values);
    if (a.values[0] != aggregated(other, 0.5, tick).values[0]) ++different;
  }
  EXPECT_GT(different, 150);
}

TEST(InfraredSensor, LosesTheSpotWithTheStatedProbability) {
  InfraredSensor sensor = made_sensor("dropout = 0.2");
  constexpr int kSamples = 20000;
  int lost = 0;
  for (Tick tick = 0; tick < kSamples; ++tick) {
    const SensorReading v = aggregated(sensor, 0.2, tick);
    if (v.values[1] != 0) continue;
    ++lost;
    expect_nothing_seen(v);
  }
  EXPECT_NEAR(lost / double{kSamples}, 0.2, 0.01);
}

TEST(InfraredSensor, EveryReadingWithoutAnErrorIsWithinTheRange) {
  EXPECT_TRUE(rc::check([] {
    InfraredSensor sensor = made_sensor("noise = 2.0\ndropout = 0.1");
    for (Tick tick = 0; tick < 100; ++tick) {
      const double range = 0.01 * *rc::gen::inRange(-10, 100);
      const SensorReading v = aggregated(sensor, range < 0 ? -1 : range, tick);
      RC_ASSERT((v.error.error_class != ErrorClass::none) == (range >= 0 && range < 0.1));
      if (v.error.error_class != ErrorClass::none) continue;
      RC_ASSERT(v.values[0] >= 0.1);
      RC_ASSERT(v.values[0] <= 0.8);
      RC_ASSERT(v.values[1] == 1 || (v.values[0] == 0.8 && v.values[2] == 0));
    }
  }));
}

TEST(InfraredSensor, RefusesParametersThatContradictEachOther) {
  EXPECT_FALSE(made_sensor().bias(RawReading{}));
  EXPECT_THROW(made_sensor("dead_zone = 0.8"), SystemError);
  EXPECT_THROW(made_sensor("presence = 0.09"), SystemError);
  EXPECT_THROW(made_sensor("presence = 0.79"), SystemError);  // and the hysteresis of 0.02 m
  EXPECT_NO_THROW(made_sensor("presence = 0.79\nhysteresis = 0.01"));
  EXPECT_THROW(made_sensor("noise = -0.1"), config::ConfigurationError);
  EXPECT_THROW(made_sensor("dropout = 1.1"), config::ConfigurationError);
}

TEST(InfraredSensor, DoesNotAllocateAfterItsConfiguration) {
  InfraredSensor sensor = made_sensor("noise = 0.01\ndropout = 0.1");
  const std::size_t before = test::thread_allocations();
  int errors = 0;
  for (const double range : {-1.0, -0.5, 0.0, 0.5, 5.0}) {
    sensor.track(raw(range, 3));
    if (aggregated(sensor, range, 3).error.error_class != ErrorClass::none) ++errors;
  }
  EXPECT_EQ(test::thread_allocations() - before, 0U);
  EXPECT_EQ(errors, 2);
}

}  // namespace
}  // namespace mrroc::vsp
