#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sensors/force_torque/made_sensor.hpp"

namespace mrroc::vsp::noise_and_filter_test {
namespace {

Wrench force_z(double newtons) { return Wrench{{0, 0, newtons, 0, 0, 0}}; }

TEST(ForceTorqueNoise, HasTheStatedDeviationOnEveryAxis) {
  ForceTorqueSensor sensor = made_sensor("force_noise = 0.5\ntorque_noise = 0.02");
  constexpr int kSamples = 20000;
  Wrench sum = Wrench::Zero(), squares = Wrench::Zero();
  for (Tick tick = 0; tick < kSamples; ++tick) {
    const Wrench w = wrench_of(aggregated(sensor, raw_of(Wrench::Zero(), tick)));
    sum += w;
    squares += w.cwiseAbs2();
  }
  for (int i = 0; i < 6; ++i) {
    const double deviation = i < 3 ? 0.5 : 0.02;
    EXPECT_NEAR(std::sqrt(squares[i] / kSamples), deviation, 0.02 * deviation);
    EXPECT_NEAR(sum[i] / kSamples, 0, 0.03 * deviation);
  }
}

TEST(ForceTorqueNoise, DependsOnNameAndTickOnly) {
  ForceTorqueSensor one = made_sensor("force_noise = 1.0", "left");
  ForceTorqueSensor same = made_sensor("force_noise = 1.0", "left");
  ForceTorqueSensor other = made_sensor("force_noise = 1.0", "right");
  for (Tick tick = 0; tick < 50; ++tick) aggregated(one, raw_of(force_z(5), tick));
  const RawReading r = raw_of(Wrench::Zero(), 50);
  EXPECT_EQ(aggregated(one, r).values, aggregated(same, r).values);
  EXPECT_NE(aggregated(one, r).values, aggregated(other, r).values);
}

TEST(ForceTorqueFilter, StepResponseHasTheTimeConstant) {
  // 1 / (2 pi f) = 25 ticks of 2 ms
  const double cutoff = 1 / (2 * std::numbers::pi * 25 * kServoPeriod);
  ForceTorqueSensor sensor = made_sensor("cutoff = " + std::to_string(cutoff));
  EXPECT_TRUE(sensor.continuous());
  sensor.track(raw_of(force_z(0), 0));
  for (Tick tick = 1; tick <= 25; ++tick) sensor.track(raw_of(force_z(10), tick));
  EXPECT_NEAR(wrench_of(aggregated(sensor, raw_of(force_z(10), 25)))[2], 10 * (1 - std::exp(-1)), 1e-5);
}

TEST(ForceTorqueFilter, DampsASineOfItsCutOffByThreeDecibels) {
  ForceTorqueSensor sensor = made_sensor("cutoff = 2.0");
  double largest = 0;
  for (Tick tick = 0; tick < 5000; ++tick) {
    const double time = static_cast<double>(tick) * kServoPeriod;
    const RawReading r = raw_of(force_z(std::sin(2 * std::numbers::pi * 2.0 * time)), tick);
    sensor.track(r);
    if (tick > 2500) largest = std::max(largest, wrench_of(aggregated(sensor, r))[2]);
  }
  EXPECT_NEAR(20 * std::log10(largest), -3.01, 0.12);
}

TEST(ForceTorqueFilter, LagsBehindARampByItsStatedDelay) {
  for (const double cutoff : {0.5, 5.0, 40.0, 250.0}) {
    ForceTorqueSensor sensor = made_sensor("cutoff = " + std::to_string(cutoff));
    const double slope = 3;  // N/s
    Tick tick = 0;
    for (; tick < 5000; ++tick) sensor.track(raw_of(force_z(slope * static_cast<double>(tick) * kServoPeriod), tick));
    const double force = slope * static_cast<double>(tick) * kServoPeriod;
    const double lag = (force - wrench_of(aggregated(sensor, raw_of(force_z(force), tick)))[2]) / slope;
    EXPECT_NEAR(lag, sensor.delay(), 1e-9) << cutoff;
    EXPECT_NEAR(sensor.delay(), 1 / (2 * std::numbers::pi * cutoff) - kServoPeriod / 2, 0.3 * kServoPeriod) << cutoff;
  }
  EXPECT_EQ(made_sensor().delay(), 0);
}

TEST(ForceTorqueFilter, IgnoresReadingsBeyondTheRange) {
  ForceTorqueSensor with = made_sensor("cutoff = 5.0"), without = made_sensor("cutoff = 5.0");
  for (Tick tick = 0; tick < 20; ++tick) {
    without.track(raw_of(force_z(10), tick));
    with.track(raw_of(force_z(tick == 10 ? 1e6 : 10), tick));
  }
  const RawReading r = raw_of(force_z(10), 20);
  EXPECT_NEAR(wrench_of(aggregated(with, r))[2], wrench_of(aggregated(without, r))[2], 1e-12);
}

TEST(ForceTorqueFilter, IsOffByDefault) {
  ForceTorqueSensor sensor = made_sensor();
  EXPECT_FALSE(sensor.continuous());
  aggregated(sensor, raw_of(force_z(0), 0));
  EXPECT_EQ(wrench_of(aggregated(sensor, raw_of(force_z(10), 1)))[2], 10);
}

}  // namespace
}  // namespace mrroc::vsp::noise_and_filter_test
