#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "sensors/infrared/made_sensor.hpp"

namespace mrroc::vsp {
namespace {

/// On at 0.3 m, off beyond 0.35 m.
InfraredSensor switching() { return made_sensor("presence = 0.3\nhysteresis = 0.05"); }

bool presence_at(InfraredSensor& sensor, double range) { return aggregated(sensor, range).values[2] == 1; }

TEST(InfraredPresence, SwitchesOnAtItsDistanceAndOffBeyondTheHysteresis) {
  InfraredSensor sensor = switching();
  EXPECT_FALSE(presence_at(sensor, 0.35));  // between the two, from off
  EXPECT_FALSE(presence_at(sensor, 0.301));
  EXPECT_TRUE(presence_at(sensor, 0.3));
  EXPECT_TRUE(presence_at(sensor, 0.349));
  EXPECT_FALSE(presence_at(sensor, 0.351));
  EXPECT_FALSE(presence_at(sensor, 0.301));
  EXPECT_TRUE(presence_at(sensor, 0.1));
  EXPECT_FALSE(presence_at(sensor, -1));
}

TEST(InfraredPresence, KeepsItsStateWhileATargetIsInTheDeadZone) {
  InfraredSensor sensor = switching();
  aggregated(sensor, 0.05);
  EXPECT_FALSE(presence_at(sensor, 0.32));
  EXPECT_TRUE(presence_at(sensor, 0.2));
  aggregated(sensor, 0.05);
  EXPECT_TRUE(presence_at(sensor, 0.32));
}

TEST(InfraredPresence, NoiseWithinTheHysteresisNeverSwitchesIt) {
  EXPECT_TRUE(rc::check([] {
    InfraredSensor sensor = switching();
    bool on = false;
    int changes = 0;
    for (int i = 0; i < 200; ++i) {
      const double range = 0.3001 + 0.0001 * *rc::gen::inRange(0, 499);
      const bool now = presence_at(sensor, range);
      changes += now != on ? 1 : 0;
      on = now;
    }
    RC_ASSERT(changes == 0);
  }));
}

TEST(InfraredPresence, IsEvaluatedEveryTickForAnyRequests) {
  EXPECT_TRUE(rc::check([] {
    InfraredSensor asked = switching(), unasked = switching();
    EXPECT_TRUE(asked.continuous());
    double range = -1;
    for (Tick tick = 0; tick < 100; ++tick) {
      range = *rc::gen::inRange(0, 5) == 0 ? -1 : 0.001 * *rc::gen::inRange(0, 900);
      asked.track(raw(range, tick));
      unasked.track(raw(range, tick));
      if (*rc::gen::arbitrary<bool>()) aggregated(asked, range, tick);
      if (*rc::gen::arbitrary<bool>()) asked.track(raw(range, tick));
    }
    RC_ASSERT(presence_at(asked, 0.32) == presence_at(unasked, 0.32));
  }));
}

}  // namespace
}  // namespace mrroc::vsp
