#include <array>
#include <cmath>

#include "clock/wall/monotonic.hpp"
#include "clock/wall/wait.hpp"
#include "testing/driver/checks.hpp"

namespace mrroc::driver_test {

namespace {

constexpr double kOffPeriod = 0.02;  // of a servo period, by which clocks differ
constexpr int kBeats = 200;
constexpr double kOffBeat = 0.25;  // of a period, between two times of the controller

/// Of a robot whose controller keeps the time.
edp::RobotClock& opened_clock(Bench& bench) {
  if (bench.device().simulated_time()) throw NotMade("the test gives the device's time");
  bench.open();
  edp::RobotClock* const clock = bench.hardware().clock();
  if (clock == nullptr) throw NotMade("the driver has no clock of its own");
  return *clock;
}

/// Each beat is a package of its own, and what the driver says of its time is true.
void beats(Bench& bench) {
  const edp::RobotClock& clock = opened_clock(bench);
  const double period = clock.period(), ratio = period / bench.period();
  expect(ratio > 1 - kOffPeriod && std::abs(ratio - std::round(ratio)) < kOffPeriod * ratio,
         "its period is " + std::to_string(ratio) + " servo periods, expected an integer from 1 on");
  edp::Beat last, beat;
  expect(bench.beat(last), "no package in 100 periods");
  const std::uint64_t first = clock.counters().packages;
  for (std::uint64_t i = 0; i < kBeats; ++i) {
    // the servo comes at every part of a period, also while a package arrives
    clock::pause(std::llround(1e9 * period * static_cast<double>(i) / kBeats));
    expect(bench.beat(beat), "no package in 100 periods");
    const double step = (beat.time - last.time) / period;
    expect(step > 0.5 && std::abs(step - std::round(step)) < kOffBeat,
           "between two beats are " + std::to_string(step) + " of its periods, expected an integer from 1 on");
    expect(beat.received >= last.received && beat.received <= clock::monotonic_ns(),
           "a package was received before the last one, or is not received yet");
    // the package of the next beat may have been counted with the first one
    expect(clock.counters().packages >= first + i, "more beats than packages are counted");
    expect(clock.period() == period, "its period has changed");
    last = beat;
  }
}

/// The servo must tick without packages, too: it stops the robot.
void ends_waits(Bench& bench) {
  bench.need(Trouble::silence);
  edp::RobotClock& clock = opened_clock(bench);
  edp::Beat beat;
  for (int i = 0; i < 20; ++i) bench.beat(beat);
  bench.device().set(Trouble::silence, true);
  for (int ended = 0, waits = 0; ended < 20; ++waits) {
    expect(waits < 500, "the device is silent, and packages still come");
    const std::int64_t deadline = clock::monotonic_ns() + std::llround(5e9 * clock.period());
    const bool came = clock.wait(deadline, beat);
    expect(came || clock::monotonic_ns() >= deadline, "a wait has ended before its deadline, without a package");
    if (!came) ++ended;
  }
  bench.device().set(Trouble::silence, false);
  bool back = false;
  for (int i = 0; i < 100 && !back; ++i) back = bench.beat(beat);
  expect(back, "the silence has ended, and no package has come in 10000 periods");
}

void counts_troubles(Bench& bench) {
  struct Counted {
    Trouble trouble;
    std::uint64_t edp::BeatCounters::*counter;
    const char* name;
  };
  constexpr std::array kCounted{Counted{Trouble::loss, &edp::BeatCounters::lost, "lost"},
                                Counted{Trouble::doubling, &edp::BeatCounters::doubled, "doubled"},
                                Counted{Trouble::lateness, &edp::BeatCounters::late, "late"}};
  const edp::RobotClock& clock = opened_clock(bench);
  for (const Counted& each : kCounted) {
    bench.need(each.trouble);
    edp::Beat beat;
    for (int i = 0; i < 50; ++i) bench.beat(beat);
    const std::uint64_t before = clock.counters().*each.counter;
    bench.device().set(each.trouble, true);
    for (int i = 0; i < 100; ++i) bench.beat(beat);
    bench.device().set(each.trouble, false);
    expect(clock.counters().*each.counter > before,
           std::string("packages are ").append(each.name).append(", and none is counted"));
  }
}

constexpr std::array kClockChecks{
    Check{"beats", "each tick of the driver's own clock is a new package, a whole number of periods later", beats},
    Check{"beats_end", "without packages a wait ends at its deadline; packages that come again are beats", ends_waits},
    Check{"beats_counted", "lost, doubled and late packages are counted", counts_troubles}};

}  // namespace

std::span<const Check> clock_checks() { return kClockChecks; }

}  // namespace mrroc::driver_test
