#pragma once

#include "mrroc/fixed_text.hpp"
#include "mrroc/robot_state.hpp"

namespace mrroc::links {

enum class ProcessRole : std::uint8_t { mp = 0, ecp = 1, edp = 2, vsp = 3, sim = 4 };
enum class ProcessState : std::uint8_t { starting = 0, ready = 1, running = 2, ended = 3, failed = 4 };

/// Counts since the process started, and times of its servo tick, microseconds.
struct Counters {
  std::uint64_t ticks = 0;
  std::uint64_t missed_ticks = 0;
  std::uint64_t late_commands = 0;
  std::uint64_t stale_replies = 0;
  std::uint64_t common_steps = 0;  ///< of several robots
  std::uint64_t skew_ticks = 0;    ///< their worst: last minus first start of a macrostep
  std::uint64_t packages = 0;      ///< of a robot that keeps the time of its servo (BeatCounters); 0: it does not
  std::uint64_t packages_lost = 0;
  std::uint64_t packages_doubled = 0;
  std::uint64_t packages_late = 0;
  std::uint64_t packages_bunched = 0;
  double wakeup_p50_us = 0;
  double wakeup_p99_us = 0;
  double wakeup_max_us = 0;
  double execution_p50_us = 0;
  double execution_p99_us = 0;
  double execution_max_us = 0;
};

/// Telemetry of one process, for operators. No decision depends on it.
struct ProcessStatus {
  FixedText<kNameLength> process;
  ProcessRole role = ProcessRole::mp;
  ProcessState state = ProcessState::starting;
  std::uint64_t boot = 0;  ///< `Domain::boot`
  std::uint64_t beat = 0;  ///< counts the statuses of this process: its heartbeat
  std::int32_t pid = 0;
  Tick tick = 0;
  std::uint64_t instruction = 0;  ///< number of the current Move or Wait
  FixedText<63> activity;         ///< its text, e.g. "Move ToolVelocity"
  std::uint64_t step = 0;         ///< its step i
  ErrorReport error;
  Counters counters;
};

}  // namespace mrroc::links
