#include "cli/report.hpp"

#include <spdlog/fmt/fmt.h>

namespace mrroc::cli {

namespace {

void print_servo(const links::ProcessStatus& status, bool real) {
  const links::Counters& counters = status.counters;
  fmt::print("  {:<10} {} ticks, {} missed, {} late commands", status.process.view(), counters.ticks,
             counters.missed_ticks, counters.late_commands);
  if (real) {
    fmt::print("; wake-up p50 {:.0f} p99 {:.0f} max {:.0f} us; tick p50 {:.0f} p99 {:.0f} max {:.0f} us",
               counters.wakeup_p50_us, counters.wakeup_p99_us, counters.wakeup_max_us, counters.execution_p50_us,
               counters.execution_p99_us, counters.execution_max_us);
  }
  fmt::print("\n");
}

/// The simulator in real time: its missed ticks were simulated late.
void print_simulator(const links::ProcessStatus& status) {
  fmt::print("  {:<10} {} ticks, {} missed\n", status.process.view(), status.counters.ticks,
             status.counters.missed_ticks);
}

void print_skew(const links::ProcessStatus& status) {
  fmt::print("  {:<10} {} steps of several robots, skew {} ticks\n", status.process.view(),
             status.counters.common_steps, status.counters.skew_ticks);
}

}  // namespace

void print_report(const config::Deployment& deployment, const RunResult& result) {
  const double simulated = static_cast<double>(result.ticks) * deployment.servo_period;
  const char* word = result.code == process::ExitCode::success ? "succeeded" : "ended";
  fmt::print("{} {}: {:.3f} s in {:.2f} s of wall time", deployment.name, word, simulated, result.wall_seconds);
  if (deployment.clock == config::ClockMode::lockstep && result.wall_seconds > 0) {
    fmt::print(" ({:.1f} x real time)", simulated / result.wall_seconds);
  }
  fmt::print("\n");
  for (const auto& [name, status] : result.statuses) {
    if (status.counters.common_steps > 0) print_skew(status);
    const bool real = deployment.clock == config::ClockMode::real;
    if (status.role == links::ProcessRole::edp) print_servo(status, real);
    if (status.role == links::ProcessRole::sim && real) print_simulator(status);
  }
  for (const std::string& line : result.hosts) fmt::print("  {}\n", line);
}

}  // namespace mrroc::cli
