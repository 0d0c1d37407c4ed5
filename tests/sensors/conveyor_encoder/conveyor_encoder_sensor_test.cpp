#include "sensors/conveyor_encoder/conveyor_encoder_sensor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "allocations.hpp"
#include "sensors/conveyor_encoder/made_sensor.hpp"

namespace mrroc::vsp {
namespace {

double any_travel() { return 1e-7 * *rc::gen::inRange(-2'000'000'000, 2'000'000'000); }

TEST(ConveyorEncoderSensor, CountsWholeIncrementsOfTheConveyorsMotor) {
  ConveyorEncoderSensor sensor = made_sensor();
  const double increment = 2 * M_PI / 4000 / 2250;
  EXPECT_NEAR(aggregated(sensor, raw(1000.4 * increment)).values[0], 1000 * increment, 1e-15);
  EXPECT_NEAR(aggregated(sensor, raw(-1000.6 * increment)).values[0], -1001 * increment, 1e-15);
  EXPECT_EQ(aggregated(sensor, raw(3, -0.04)).values[1], -0.04);
}

TEST(ConveyorEncoderSensor, PositionIsTheNumberOfIncrementsNearestToTheTravel) {
  EXPECT_TRUE(rc::check([] {
    ConveyorEncoderSensor sensor = made_sensor("resolution = 0.001");
    const double travel = any_travel();
    const double position = aggregated(sensor, raw(travel)).values[0];
    RC_ASSERT(std::abs(position - travel) <= 0.0005 * (1 + 1e-9));
    RC_ASSERT(std::abs(position / 0.001 - std::round(position / 0.001)) < 1e-6);
  }));
}

TEST(ConveyorEncoderSensor, PositionIsTheTravelWithoutAResolution) {
  EXPECT_TRUE(rc::check([] {
    ConveyorEncoderSensor sensor = made_sensor("resolution = 0.0");
    const double travel = any_travel();
    RC_ASSERT(aggregated(sensor, raw(travel)).values[0] == travel);
  }));
}

TEST(ConveyorEncoderSensor, BiasSetsItsZero) {
  EXPECT_TRUE(rc::check([] {
    ConveyorEncoderSensor sensor = made_sensor("resolution = 0.0");
    const double zero = any_travel(), later = any_travel();
    RC_ASSERT(sensor.bias(raw(any_travel())));
    RC_ASSERT(sensor.bias(raw(zero)));
    RC_ASSERT(aggregated(sensor, raw(zero)).values[0] == 0);
    RC_ASSERT(aggregated(sensor, raw(later)).values[0] == later - zero);
  }));
}

TEST(ConveyorEncoderSensor, RefusesANegativeResolution) {
  EXPECT_THROW(made_sensor("resolution = -0.001"), config::ConfigurationError);
}

TEST(ConveyorEncoderSensor, DoesNotAllocateAfterItsConfiguration) {
  ConveyorEncoderSensor sensor = made_sensor();
  const std::size_t before = test::thread_allocations();
  sensor.bias(raw(0.3));
  const double position = aggregated(sensor, raw(1.3, 0.1)).values[0];
  EXPECT_EQ(test::thread_allocations() - before, 0U);
  EXPECT_NEAR(position, 1, 1e-6);
}

}  // namespace
}  // namespace mrroc::vsp
