#include "sensors/time/time_sensor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "allocations.hpp"
#include "sensors/time/made_sensor.hpp"

namespace mrroc::vsp {
namespace {

Tick any_tick() { return *rc::gen::inRange<Tick>(0, Tick{1} << 50); }

TEST(TimeSensor, ClockIsReadAtEveryTickAndReturnsItsNumber) {
  TimeSource source;
  for (const Tick tick : {Tick{0}, Tick{7}, Tick{1} << 53}) {
    RawReading r;
    EXPECT_EQ(source.read(tick, r), SourceState::ready);
    EXPECT_EQ(r.tick, tick);
    EXPECT_EQ(r.count, 1U);
    EXPECT_EQ(r.values[0], static_cast<double>(tick));
  }
}

TEST(TimeSensor, TimeIsTicksTimesTheServoPeriod) {
  TimeSensor sensor = made_sensor(0.001);
  EXPECT_EQ(aggregated(sensor, 0).values[0], 0);
  EXPECT_EQ(aggregated(sensor, 1500).values[0], 1.5);
  EXPECT_EQ(aggregated(sensor, 1500).values[1], 1500);
}

TEST(TimeSensor, BiasSetsTheZeroOfTheTimeAndNotOfTheTick) {
  EXPECT_TRUE(rc::check([] {
    TimeSensor sensor = made_sensor(0.002);
    const Tick zero = any_tick(), later = any_tick();
    RC_ASSERT(sensor.bias(raw(any_tick())));
    RC_ASSERT(sensor.bias(raw(zero)));
    RC_ASSERT(aggregated(sensor, zero).values[0] == 0);
    const SensorReading v = aggregated(sensor, later);
    RC_ASSERT(v.values[0] == (static_cast<double>(later) - static_cast<double>(zero)) * 0.002);
    RC_ASSERT(v.values[1] == static_cast<double>(later));
  }));
}

TEST(TimeSensor, SourceIsTheClockUnlessItIsReplayed) {
  TimeSensor sensor = made_sensor();
  const config::Deployment deployment;
  config::SensorEntry entry;
  entry.source = "hardware";
  const auto clock = sensor.open_source({deployment, entry, 0, nullptr, 0.002});
  ASSERT_TRUE(clock);
  RawReading r;
  EXPECT_EQ(clock->read(12, r), SourceState::ready);
  EXPECT_EQ(r.values[0], 12);
  entry.source = "replay";
  EXPECT_FALSE(sensor.open_source({deployment, entry, 0, nullptr, 0.002}));
}

TEST(TimeSensor, DoesNotAllocateAfterItsConfiguration) {
  TimeSensor sensor = made_sensor();
  const std::size_t before = test::thread_allocations();
  sensor.bias(raw(100));
  const double time = aggregated(sensor, 600).values[0];
  EXPECT_EQ(test::thread_allocations() - before, 0U);
  EXPECT_EQ(time, 1);
}

}  // namespace
}  // namespace mrroc::vsp
