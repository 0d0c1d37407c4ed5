// A simulated sensor whose time stands still during a reading.
#include "drivers/netft/lockstep_netft.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "drivers/netft/netft_rig.hpp"

namespace mrroc::netft::lockstep_netft_test {
namespace {

using vsp::SourceState;

/// A stand-in whose load along z is 100 N per second of simulated time, from 7 N.
class SteppedSensor {
 public:
  SteppedSensor() {
    sim::NetftSettings settings = free_ports();
    settings.now = [this] { return to_ns(static_cast<double>(tick.load()) * kServoPeriod); };
    server = std::make_unique<sim::NetftServer>(settings, [](double time) {
      return Wrench{{0, 0, force(time), 0, 0, 1}};
    });
    options.address = "127.0.0.1";
    options.port = server->port();
    options.start_timeout = 30;
  }

  static double force(double time) { return 7 + 100 * time; }
  static double force_at(Tick when) { return force(static_cast<double>(when) * kServoPeriod); }
  LockstepNetft client() const { return {options, {1e-6, 1e-6}, kServoPeriod}; }

  std::atomic<Tick> tick{0};
  std::unique_ptr<sim::NetftServer> server;
  NetftOptions options;
};

TEST(LockstepNetft, AReadingIsThatOfItsTick) {
  SteppedSensor sensor;
  LockstepNetft first = sensor.client(), second = sensor.client();
  for (Tick tick = 0; tick < 2000; tick += 1 + tick % 7) {
    sensor.tick.store(tick);
    for (LockstepNetft* const each : {&first, &second, &first}) {
      vsp::RawReading raw;
      ASSERT_EQ(each->read(tick, raw), SourceState::ready);
      EXPECT_EQ(raw.tick, tick);
      EXPECT_EQ(raw.count, 6u);
      EXPECT_NEAR(raw.values[2], -SteppedSensor::force_at(tick), 1e-6);
      EXPECT_NEAR(raw.values[5], -1, 1e-6);
    }
  }
}

TEST(LockstepNetft, LostAndDoubledRecordsDoNotChangeAReading) {
  SteppedSensor sensor;
  LockstepNetft client = sensor.client();
  sim::NetftFaults faults;
  faults.loss = 0.2;
  faults.doubled = 0.8;
  faults.garbage = 0.5;
  sensor.server->set_faults(faults);
  for (Tick tick = 0; tick < 20; ++tick) {
    sensor.tick.store(tick);
    vsp::RawReading raw;
    ASSERT_EQ(client.read(tick, raw), SourceState::ready);
    EXPECT_NEAR(raw.values[2], -SteppedSensor::force_at(tick), 1e-6) << tick;
  }
}

TEST(LockstepNetft, TheLoadAtTick0BecomesTheZero) {
  SteppedSensor sensor;
  sensor.options.set_bias = true;
  LockstepNetft first = sensor.client(), second = sensor.client();
  sensor.tick.store(100);
  for (LockstepNetft* const each : {&first, &second}) {
    vsp::RawReading raw;
    ASSERT_EQ(each->read(100, raw), SourceState::ready);
    EXPECT_NEAR(raw.values[2], -20, 2e-6);
    EXPECT_NEAR(raw.values[5], 0, 2e-6);
  }
}

TEST(LockstepNetft, AnInvalidStatusIsAFaultWithItsText) {
  SteppedSensor sensor;
  LockstepNetft client = sensor.client();
  sim::NetftFaults faults;
  faults.status = kErrorSummary | kSaturated;
  sensor.server->set_faults(faults);
  vsp::RawReading raw;
  EXPECT_EQ(client.read(0, raw), SourceState::faulty);
  EXPECT_NE(client.fault().find("0x80020000"), std::string_view::npos) << client.fault();
}

TEST(LockstepNetft, AStandInThatHasEndedIsSilentAtOnce) {
  SteppedSensor sensor;
  LockstepNetft client = sensor.client();
  vsp::RawReading raw;
  ASSERT_EQ(client.read(0, raw), SourceState::ready);
  sensor.server.reset();
  const std::int64_t begin = clock::monotonic_ns();
  EXPECT_EQ(client.read(1, raw), SourceState::silent);
  EXPECT_EQ(client.read(2, raw), SourceState::silent);
  EXPECT_LT(clock::monotonic_ns() - begin, LockstepNetft::kTimeout / 2);
}

}  // namespace
}  // namespace mrroc::netft::lockstep_netft_test
