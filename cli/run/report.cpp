#include "cli/run/report.hpp"

#include <spdlog/fmt/fmt.h>

namespace mrroc::cli {

namespace {

void add_servo(std::string& text, const links::ProcessStatus& status, bool real) {
  const links::Counters& counters = status.counters;
  text += fmt::format("  {:<10} {} ticks, {} missed, {} late commands", status.process.view(), counters.ticks,
                      counters.missed_ticks, counters.late_commands);
  const bool keeps_time = counters.packages > 0;
  if (real && !keeps_time) {
    text += fmt::format("; wake-up p50 {:.0f} p99 {:.0f} max {:.0f} us; tick p50 {:.0f} p99 {:.0f} max {:.0f} us",
                        counters.wakeup_p50_us, counters.wakeup_p99_us, counters.wakeup_max_us,
                        counters.execution_p50_us, counters.execution_p99_us, counters.execution_max_us);
  }
  if (keeps_time) {
    text += fmt::format("; skew p50 {:.0f} p99 {:.0f} max {:.0f} us; tick p50 {:.0f} p99 {:.0f} max {:.0f} us",
                        counters.wakeup_p50_us, counters.wakeup_p99_us, counters.wakeup_max_us,
                        counters.execution_p50_us, counters.execution_p99_us, counters.execution_max_us);
    text += fmt::format("\n  {:<10} {} packages of its clock, {} lost, {} doubled, {} late, {} bunched", "",
                        counters.packages, counters.packages_lost, counters.packages_doubled, counters.packages_late,
                        counters.packages_bunched);
  }
  text += "\n";
}

/// The simulator in real time: it simulated missed ticks late.
void add_simulator(std::string& text, const links::ProcessStatus& status) {
  text += fmt::format("  {:<10} {} ticks, {} missed\n", status.process.view(), status.counters.ticks,
                      status.counters.missed_ticks);
}

void add_skew(std::string& text, const links::ProcessStatus& status) {
  text += fmt::format("  {:<10} {} steps of several robots, skew {} ticks\n", status.process.view(),
                      status.counters.common_steps, status.counters.skew_ticks);
}

}  // namespace

std::string report_of(const config::Deployment& deployment, const RunResult& result) {
  std::string text;
  const double simulated = static_cast<double>(result.ticks) * deployment.servo_period;
  const char* word = result.code == process::ExitCode::success ? "succeeded" : "ended";
  text +=
      fmt::format("{} {}: {:.3f} s in {:.2f} s of wall time", deployment.name, word, simulated, result.wall_seconds);
  if (deployment.clock == config::ClockMode::lockstep && result.wall_seconds > 0) {
    text += fmt::format(" ({:.1f} x real time)", simulated / result.wall_seconds);
  }
  text += "\n";
  for (const auto& [name, status] : result.statuses) {
    if (status.counters.common_steps > 0) add_skew(text, status);
    const bool real = deployment.clock == config::ClockMode::real;
    if (status.role == links::ProcessRole::edp) add_servo(text, status, real);
    if (status.role == links::ProcessRole::sim && real) add_simulator(text, status);
  }
  for (const std::string& line : result.hosts) text += fmt::format("  {}\n", line);
  text.pop_back();
  return text;
}

}  // namespace mrroc::cli
