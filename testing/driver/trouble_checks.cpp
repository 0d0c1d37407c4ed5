#include <algorithm>
#include <array>

#include "testing/driver/checks.hpp"

namespace mrroc::driver_test {

namespace {

constexpr int kIntoMotion = 80;    // ticks
constexpr int kFound = 500;        // ticks: until a fault must be found
constexpr int kStop = 3000;        // ticks: until the robot rests, on a drive's own ramp
constexpr double kRest = 0.02;     // rad of a shaft
constexpr double kLateTicks = 12;  // by which a reading may lag behind the shaft

/// A robot in motion, then the trouble.
void begin(Bench& bench, Trouble trouble) {
  bench.need(trouble);
  bench.open();
  bench.power();
  bench.start_move(1);
  bench.servo_ticks(kIntoMotion);
  bench.device().set(trouble, true);
}

bool has_fault(const edp::Snapshot& seen) { return seen.fault.code != ErrorCode::none; }

/// The trouble is found; the robot stops, its drives go off, and nothing moves.
void expect_stop(Bench& bench, const char* trouble) {
  expect(bench.servo_until(has_fault, kFound), std::string(trouble).append(", and there is no fault in 500 ticks"));
  expect(bench.servo_until([&](const edp::Snapshot&) { return !bench.drives_on(); }, kStop),
         std::string(trouble).append(", and the drives are still on after 3000 ticks"));
  bench.servo_ticks(300);
  const JointVector there = bench.device().shafts();
  bench.servo_ticks(50);
  const double way = farthest(bench.device().shafts(), there);
  expect(way < kRest,
         std::string(trouble).append(", and a shaft turns by " + std::to_string(way) + " rad after the stop"));
}

void expect_recovery(Bench& bench, const char* trouble) {
  const bool recovered = bench.recover();
  expect(recovered, std::string("after ").append(trouble).append(" the drives stay off: ") + bench.reason());
  const bool moved = bench.move(-0.3);
  expect(moved, std::string("after ").append(trouble).append(" a motion is broken off: ") + bench.reason());
}

/// Readings that the servo uses are those of the shafts, at most some ticks ago.
void expect_truth(Bench& bench, Trouble trouble, const char* name) {
  begin(bench, trouble);
  JointVector last = bench.device().shafts();
  double fastest = 0, off = 0;
  bench.after_tick = [&] {
    const JointVector shafts = bench.device().shafts();
    fastest = std::max(fastest, farthest(shafts, last));
    last = shafts;
    if (bench.seen().enabled()) off = std::max(off, farthest(bench.seen().motors, shafts));
  };
  bench.servo_ticks(400);
  bench.device().set(trouble, false);
  bench.servo_ticks(50);
  bench.after_tick = nullptr;
  const double allowed = kLateTicks * fastest + kRest;
  expect(off < allowed, std::string(name).append(": a reading is " + std::to_string(off) +
                                                 " rad off the shaft, allowed " + std::to_string(allowed)));
  if (has_fault(bench.seen())) {
    bench.servo_until([&](const edp::Snapshot&) { return !bench.drives_on(); }, kStop);
    expect_recovery(bench, name);
  }
}

/// By the driver itself: its readings stand still, which the servo would take for a stuck axis.
void reports_silence(Bench& bench) {
  bench.need(Trouble::silence);
  bench.open();
  bench.ticks(50);
  bench.device().set(Trouble::silence, true);
  const auto found = [](const edp::HardwareInput& input) { return input.fault != ErrorCode::none; };
  expect(bench.until(found, kFound), "the device is silent, and the driver reports no fault in 500 ticks");
  expect(bench.input().motors.allFinite(), "positions are not finite when the device is silent");
}

void survives_silence(Bench& bench) {
  begin(bench, Trouble::silence);
  expect_stop(bench, "the device is silent");
  bench.device().set(Trouble::silence, false);
  bench.servo_ticks(100);
  expect_recovery(bench, "a silence");
}

void survives_loss(Bench& bench) { expect_truth(bench, Trouble::loss, "lost answers"); }
void survives_doubling(Bench& bench) { expect_truth(bench, Trouble::doubling, "doubled answers"); }
void survives_lateness(Bench& bench) { expect_truth(bench, Trouble::lateness, "late answers"); }
void survives_garbage(Bench& bench) { expect_truth(bench, Trouble::garbage, "garbage"); }

void finds_not_finite(Bench& bench) {
  begin(bench, Trouble::not_finite);
  expect_stop(bench, "the device measures NaN");
}

void finds_jump(Bench& bench) {
  begin(bench, Trouble::jump);
  expect_stop(bench, "a measurement jumps");
}

void finds_drive_fault(Bench& bench) {
  begin(bench, Trouble::drive_fault);
  expect_stop(bench, "a drive has a fault");
  bench.device().set(Trouble::drive_fault, false);
  bench.servo_ticks(20);
  expect_recovery(bench, "a drive's fault");
}

void finds_restart(Bench& bench) {
  begin(bench, Trouble::restart);
  expect_stop(bench, "the device restarts");
  bench.device().set(Trouble::restart, false);
  bench.servo_ticks(20);
  expect_recovery(bench, "a restart");
}

constexpr std::array kTroubleChecks{
    Check{"silence", "a silent device is a fault, and its last positions stay", reports_silence},
    Check{"silence_ends", "in a silence the robot stops; after it the robot can be recovered", survives_silence},
    Check{"loss", "lost answers falsify no position", survives_loss},
    Check{"doubling", "doubled answers falsify no position", survives_doubling},
    Check{"lateness", "late answers falsify no position", survives_lateness},
    Check{"garbage", "garbage falsifies no position", survives_garbage},
    Check{"not_finite", "a measurement that is no number stops the robot", finds_not_finite},
    Check{"jump", "a measurement that jumps stops the robot", finds_jump},
    Check{"drive_fault", "a drive's fault is found, and can be reset", finds_drive_fault},
    Check{"restart", "a device that restarts is found, and the robot can be recovered", finds_restart}};

}  // namespace

std::span<const Check> trouble_checks() { return kTroubleChecks; }

}  // namespace mrroc::driver_test
