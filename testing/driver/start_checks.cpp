#include <array>

#include "config/table.hpp"
#include "mrroc/errors.hpp"
#include "testing/driver/checks.hpp"

namespace mrroc::driver_test {

namespace {

constexpr double kNear = 0.01;  // rad of a shaft: far below what any check moves, above an encoder's increment
constexpr int kFirstReading = 200;

/// Opened, with a first complete reading.
void read_first(Bench& bench) {
  bench.open();
  expect(bench.until([](const edp::HardwareInput& input) { return input.motors.allFinite(); }, kFirstReading),
         "no complete reading in 200 ticks");
}

void declares(Bench& bench) {
  const config::Deployment deployment = bench.deployment();
  expect(!deployment.robots.front().driver.library.empty(), "the deployment has no library");
}

void refuses_unknown_keys(Bench& bench) {
  bench.deployment();
  try {
    bench.deployment("no_such_key = 1");
  } catch (const config::ConfigurationError&) {
    return;
  }
  throw Failure("the key no_such_key is accepted");
}

void is_made_without_device(Bench& bench) {
  bench.device().stop();
  bench.make();
}

void ends_unopened(Bench& bench) {
  bench.make();
  bench.close();
}

void needs_its_device(Bench& bench) {
  if (!bench.device().can_be_absent()) throw NotMade("its device cannot be absent");
  bench.device().stop();
  bench.make();
  try {
    bench.hardware().open();
  } catch (const HardwareError&) {
    bench.close();
    bench.open();
    return;
  }
  throw Failure("it opens without its device, expected a HardwareError");
}

void reads_every_axis(Bench& bench) {
  read_first(bench);
  const edp::HardwareInput& input = bench.ticks(10);
  expect(input.fault == ErrorCode::none, std::string("a fault at rest: ").append(describe(input.fault)));
  expect(input.motors.size() == bench.axes(), "it reads " + std::to_string(input.motors.size()) + " positions");
  expect(input.current.size() == bench.axes(), "it reads " + std::to_string(input.current.size()) + " currents");
  expect(input.motors.allFinite() && input.current.allFinite(), "a reading is not finite");
}

void reads_true_positions(Bench& bench) {
  read_first(bench);
  const edp::HardwareInput& input = bench.ticks(10);
  expect(input.synchronised, "it says that its positions are not absolute");
  const double off = farthest(input.motors, bench.device().shafts());
  expect(off < kNear, "a reading is " + std::to_string(off) + " rad off the shaft");
}

void names_its_tick(Bench& bench) {
  read_first(bench);
  double last = 0;
  for (int i = 0; i < 100; ++i) {
    const edp::HardwareInput& input = bench.tick();
    expect(input.time < static_cast<double>(bench.now()),
           "a measurement of tick " + std::to_string(input.time) + " at tick " + std::to_string(bench.now() - 1));
    expect(input.time >= last,
           "a measurement of tick " + std::to_string(input.time) + " after one of " + std::to_string(last));
    last = input.time;
  }
}

void rests(Bench& bench) {
  read_first(bench);
  const JointVector first = bench.input().motors;
  for (int i = 0; i < 100; ++i) {
    const double way = farthest(bench.tick().motors, first);
    expect(way < kNear, "without power its readings move by " + std::to_string(way) + " rad");
  }
}

void ignores_set_points_without_power(Bench& bench) {
  read_first(bench);
  const JointVector before = bench.device().shafts();
  bench.target = before.array() + 0.5;
  bench.ticks(100);
  const double way = farthest(bench.device().shafts(), before);
  expect(way < kNear, "without power a shaft turns by " + std::to_string(way) + " rad");
}

void opens_again(Bench& bench) {
  read_first(bench);
  bench.ticks(10);
  bench.close();
  bench.make();
  bench.connect();
  expect(bench.until([](const edp::HardwareInput& input) { return input.motors.allFinite(); }, kFirstReading),
         "a second driver reads nothing after the first has ended");
}

constexpr std::array kStartChecks{
    Check{"declares", "its declaration and keys are valid in a deployment", declares},
    Check{"unknown_key", "a key that it does not declare is refused", refuses_unknown_keys},
    Check{"made", "its library is of this version; it is made without its device", is_made_without_device},
    Check{"unopened", "it ends without having been opened", ends_unopened},
    Check{"absent", "without its device `open` is a HardwareError, and can be repeated", needs_its_device},
    Check{"reads", "it reads a finite position and current of every axis", reads_every_axis},
    Check{"true_positions", "the positions are those of the shafts", reads_true_positions},
    Check{"tick", "the tick of a measurement is not later than the present, and does not go back", names_its_tick},
    Check{"rests", "without power the readings do not move", rests},
    Check{"no_power_no_motion", "without power set-points move nothing", ignores_set_points_without_power},
    Check{"again", "it can be opened again after its end", opens_again}};

}  // namespace

std::span<const Check> start_checks() { return kStartChecks; }

}  // namespace mrroc::driver_test
