#include "sensors/digital_input/digital_input_sensor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "allocations.hpp"
#include "sensors/digital_input/made_sensor.hpp"

namespace mrroc::vsp {
namespace {

TEST(DigitalInputSensor, IsOnAboveItsThreshold) {
  DigitalInputSensor sensor = made_sensor("threshold = 2.5");
  EXPECT_EQ(measured(sensor, 0, 2.5).values[0], 0);
  EXPECT_EQ(measured(sensor, 1, 2.6).values[0], 1);
  EXPECT_EQ(measured(sensor, 2, -7.0).values[0], 0);
  EXPECT_EQ(measured(sensor, 3, 1.25).values[2], 1.25);
}

TEST(DigitalInputSensor, OnAtTheStartIsNotARise) {
  DigitalInputSensor sensor = made_sensor("debounce = 0.01");
  const SensorReading v = measured(sensor, 40, 1);
  EXPECT_EQ(v.values[0], 1);
  EXPECT_EQ(v.values[1], 0);
}

TEST(DigitalInputSensor, SwitchesAfterTheDebounceTime) {
  DigitalInputSensor sensor = made_sensor("debounce = 0.009");  // rounded up to 5 ticks
  measured(sensor, 0, 0);
  for (Tick tick = 10; tick < 15; ++tick) EXPECT_EQ(measured(sensor, tick, 1).values[0], 0) << tick;
  const SensorReading v = measured(sensor, 15, 1);
  EXPECT_EQ(v.values[0], 1);
  EXPECT_EQ(v.values[1], 1);
}

/// The definition itself, from the whole history: on_k = s_k when s_(k-n) = ... = s_k, else on_(k-1).
struct Reference {
  Reference(const std::vector<bool>& s, std::size_t n) : on(s.size()) {
    for (std::size_t k = 0; k < s.size(); ++k) {
      const auto same = [&](bool value) { return value == s[k]; };
      const bool steady = k >= n && std::all_of(s.begin() + static_cast<std::ptrdiff_t>(k - n),
                                                s.begin() + static_cast<std::ptrdiff_t>(k), same);
      on[k] = k == 0 || steady ? s[k] : on[k - 1];
    }
  }
  std::vector<bool> on;
};

/// Levels 0 and 1 that last for some ticks, like those of a bouncing contact.
std::vector<bool> any_contact() {
  std::vector<bool> s;
  bool value = *rc::gen::arbitrary<bool>();
  for (const int length : *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 9)))) {
    s.insert(s.end(), static_cast<std::size_t>(length), value);
    value = !value;
  }
  return s;
}

TEST(DigitalInputSensor, FollowsItsDefinitionForAnyContact) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<bool> s = any_contact();
    const auto n = *rc::gen::inRange<std::size_t>(0, 6);
    const Tick first = *rc::gen::inRange<Tick>(0, 1000);
    std::string toml = "debounce = ";
    toml += std::to_string(0.002 * static_cast<double>(n));
    DigitalInputSensor sensor = made_sensor(toml);
    const Reference reference(s, n);
    double rises = 0;
    for (std::size_t k = 0; k < s.size(); ++k) {
      if (k > 0 && reference.on[k] && !reference.on[k - 1]) ++rises;
      if (*rc::gen::arbitrary<bool>()) sensor.track(raw(first + k, s[k] ? 1 : 0));  // repetition changes nothing
      const SensorReading v = measured(sensor, first + k, s[k] ? 1 : 0);
      RC_ASSERT(v.values[0] == (reference.on[k] ? 1 : 0));
      RC_ASSERT(v.values[1] == rises);
    }
  }));
}

TEST(DigitalInputSensor, BiasSetsTheCountToZeroAndKeepsTheState) {
  DigitalInputSensor sensor = made_sensor();
  for (Tick tick = 0; tick < 6; ++tick) measured(sensor, tick, static_cast<double>(tick % 2));
  EXPECT_EQ(measured(sensor, 6, 0).values[1], 3);
  EXPECT_EQ(measured(sensor, 7, 1).values[1], 4);
  EXPECT_TRUE(sensor.bias(raw(7, 1)));
  EXPECT_EQ(measured(sensor, 8, 1).values[0], 1);
  EXPECT_EQ(measured(sensor, 8, 1).values[1], 0);
  measured(sensor, 9, 0);
  EXPECT_EQ(measured(sensor, 10, 1).values[1], 1);
}

TEST(DigitalInputSensor, RefusesADebounceTimeBelowZero) {
  EXPECT_THROW(made_sensor("debounce = -0.1"), config::ConfigurationError);
}

TEST(DigitalInputSensor, DoesNotAllocateAfterItsConfiguration) {
  DigitalInputSensor sensor = made_sensor("debounce = 0.004");
  const std::size_t before = test::thread_allocations();
  double rises = 0;
  for (Tick tick = 0; tick < 100; ++tick) rises = measured(sensor, tick, tick / 10 % 2 == 0 ? 0 : 1).values[1];
  sensor.bias(raw(100, 1));
  EXPECT_EQ(test::thread_allocations() - before, 0U);
  EXPECT_EQ(rises, 5);
}

}  // namespace
}  // namespace mrroc::vsp
