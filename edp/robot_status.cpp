#include "edp/robot_status.hpp"

#include "edp/safety/error_report.hpp"

namespace mrroc::edp {

namespace {

links::Counters counters_of(Effector& effector, Servo& servo, const clock::TickStatistics* ticks) {
  links::Counters counters;
  if (const Snapshot* snapshot = effector.snapshot()) {
    counters.ticks = snapshot->counters.ticks;
    counters.missed_ticks = snapshot->counters.missed;
  }
  counters.late_commands = effector.counters().late;
  if (ticks == nullptr) return counters;
  counters.missed_ticks = ticks->missed();  // skipped or executed late
  const auto microseconds = [](std::uint64_t ns) { return static_cast<double>(ns) * 1e-3; };
  counters.wakeup_p50_us = microseconds(ticks->lateness().percentile(0.5));
  counters.wakeup_p99_us = microseconds(ticks->lateness().percentile(0.99));
  counters.wakeup_max_us = microseconds(ticks->lateness().max());
  counters.execution_p50_us = microseconds(ticks->execution().percentile(0.5));
  counters.execution_p99_us = microseconds(ticks->execution().percentile(0.99));
  counters.execution_max_us = microseconds(ticks->execution().max());
  if (const RobotClock* const robot = servo.robot_clock()) {
    const BeatCounters beats = robot->counters();
    counters.packages = beats.packages;
    counters.packages_lost = beats.lost;
    counters.packages_doubled = beats.doubled;
    counters.packages_late = beats.late;
    counters.packages_bunched = beats.bunched;
  }
  return counters;
}

}  // namespace

void RobotStatus::report(Effector& effector, Servo& servo, const clock::TickStatistics* ticks) noexcept {
  board_.counters(counters_of(effector, servo, ticks));
  const Snapshot* const snapshot = effector.snapshot();
  if (snapshot == nullptr || snapshot->fault.code == fault_) return;
  fault_ = snapshot->fault.code;
  board_.fault(fault_ == ErrorCode::none ? ErrorReport{} : make_report(snapshot->fault, parameters_));
}

}  // namespace mrroc::edp
