#include <algorithm>
#include <array>

#include "testing/driver/checks.hpp"

namespace mrroc::driver_test {

namespace {

constexpr double kJump = 0.05;      // rad of a shaft
constexpr double kYield = 0.3;      // rad of a shaft
constexpr double kSmallPart = 0.1;  // of a motion: how near it ends
constexpr int kStandstill = 1500;   // ticks for a stop on a drive's own ramp

/// The shafts' way of a motion by `part`, rad.
JointVector shafts_of(Bench& bench, double part) {
  JointVector shafts;
  bench.model().joints_to_motors(bench.model().parameters().home + bench.way(part), shafts);
  return shafts;
}

void switches_on(Bench& bench) {
  bench.open();
  bench.ticks(20);
  bench.hardware().enable(true);
  expect(bench.until([&](const edp::HardwareInput&) { return !bench.hardware().busy(); }, 5000),
         "it is still busy 5000 ticks after `enable`");
  const edp::HardwareInput& input = bench.ticks(20);
  expect(input.fault == ErrorCode::none, std::string("a fault with power: ").append(describe(input.fault)));
}

void does_not_jump(Bench& bench) {
  bench.open();
  const JointVector before = bench.device().shafts();
  double way = 0;
  bench.after_tick = [&] { way = std::max(way, farthest(bench.device().shafts(), before)); };
  bench.power();
  bench.servo_ticks(100);
  // on currents the servo takes the weight when the brakes release, and gives way a little
  expect(way < (bench.hardware().follows_current() ? kYield : kJump),
         "a shaft turns by " + std::to_string(way) + " rad when the drives are switched on");
}

void switches_off(Bench& bench) {
  switches_on(bench);
  bench.hardware().enable(false);
  expect(bench.until([&](const edp::HardwareInput&) { return !bench.hardware().busy(); }, 5000),
         "it is still busy 5000 ticks after `enable(false)`");
  bench.ticks(20);
  const JointVector before = bench.device().shafts();
  bench.target = before.array() + 0.5;
  bench.ticks(100);
  const double way = farthest(bench.device().shafts(), before);
  expect(way < kJump, "switched off, a shaft turns by " + std::to_string(way) + " rad");
}

void moves(Bench& bench) {
  bench.open();
  bench.power();
  const JointVector start = shafts_of(bench, 0), end = shafts_of(bench, 1);
  for (int i = 0; i < 2; ++i) {
    for (const double part : {1.0, -1.0}) {
      const bool moved = bench.move(part);
      expect(moved, "a motion was broken off: " + bench.reason());
      bench.servo_ticks(200);
      const JointVector& wanted = part > 0 ? end : start;
      const JointVector allowed = (kSmallPart * (end - start)).cwiseAbs().array() + kJump;
      const JointVector off = (bench.device().shafts() - wanted).cwiseAbs();
      for (Eigen::Index k = 0; k < off.size(); ++k)
        expect(off[k] < allowed[k], "shaft " + std::to_string(k + 1) + " ends " + std::to_string(off[k]) + " rad off");
    }
  }
}

void shifts_its_origin(Bench& bench) {
  bench.open();
  const JointVector before = bench.ticks(20).motors;
  JointVector shift(bench.axes());
  for (Eigen::Index i = 0; i < shift.size(); ++i) shift[i] = 0.25 * static_cast<double>(i + 1);
  bench.hardware().set_origin(shift);
  const edp::HardwareInput& input = bench.ticks(5);
  const double off = farthest(input.motors, before + shift);
  expect(off < kJump, "after `set_origin` a reading is " + std::to_string(off) + " rad off");
  expect(input.synchronised, "after `set_origin` its positions are not absolute");
}

void takes_outputs(Bench& bench) {
  bench.open();
  bench.power();
  ControllerIo outputs;
  outputs.set(0, true);
  bench.hardware().set_outputs(outputs);
  bench.servo_ticks(50);
  bench.hardware().set_outputs({});
  bench.servo_ticks(50);
  expect(bench.seen().enabled(), std::string("outputs are a fault: ").append(describe(bench.seen().fault.code)));
}

void stops_in_motion(Bench& bench) {
  bench.open();
  bench.power();
  bench.start_move(1);
  bench.servo_ticks(100);
  bench.hardware().enable(false);
  for (int i = 0; i < kStandstill; ++i) bench.tick();
  const JointVector there = bench.device().shafts();
  for (int i = 0; i < 50; ++i) bench.tick();
  const double way = farthest(bench.device().shafts(), there);
  expect(way < kJump, "switched off in motion, a shaft turns on by " + std::to_string(way) + " rad");
}

void reports_refused_power(Bench& bench) {
  bench.need(Trouble::no_power);
  bench.open();
  bench.ticks(20);
  bench.device().set(Trouble::no_power, true);
  bench.hardware().enable(true);
  const auto found = [](const edp::HardwareInput& input) { return input.fault != ErrorCode::none; };
  expect(bench.until(found, 5000), "the device refuses its power, and there is no fault in 5000 ticks");
  bench.device().set(Trouble::no_power, false);
}

constexpr std::array kPowerChecks{
    Check{"power", "switching on ends, without a fault", switches_on},
    Check{"no_jump", "no shaft moves when the drives are switched on", does_not_jump},
    Check{"off", "switched off, set-points move nothing", switches_off},
    Check{"moves", "motions end where they should, both ways", moves},
    Check{"origin", "`set_origin` shifts every reading, and makes positions absolute", shifts_its_origin},
    Check{"outputs", "outputs disturb nothing", takes_outputs},
    Check{"off_in_motion", "switched off in motion, every shaft comes to rest", stops_in_motion},
    Check{"refused_power", "a device that refuses its power is a fault", reports_refused_power}};

}  // namespace

std::span<const Check> power_checks() { return kPowerChecks; }

}  // namespace mrroc::driver_test
