#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/run/panel_options.hpp"

namespace mrroc::cli {

/// Options of a run in addition to its deployment.
struct RunOptions {
  std::filesystem::path recording;    ///< MCAP file; empty: none
  bool record_servo_ticks = false;    ///< each tick of each servo, too
  std::optional<double> record_last;  ///< s: only the end of the run, when it fails
  std::filesystem::path black_box;    ///< folder for the black boxes of tasks that fail; empty: none
  bool black_box_named = false;       ///< not the default: a run without it is refused
  std::filesystem::path snapshots;    ///< folder for world snapshots; empty: none
  std::filesystem::path motion;       ///< file for the motion of the simulated world's robots; empty: none
  std::filesystem::path note_events;  ///< file for the operator's commands, as [[events]]; empty: none
  std::filesystem::path events;       ///< file of [[events]] that has been read; empty: the deployment's
  std::vector<std::string> faults;    ///< to be injected: faults::parse_fault
  std::string behaviours;             ///< behaviours of the ECP programs, for a state machine (config::ProgramsByRobot)
  std::string text;                   ///< of the deployment, as it was read
  bool attended = true;               ///< false: the standard input was the deployment, so no line is typed there
  bool quiet = false;
  bool hold = false;                  ///< the task waits for `start`
  std::optional<PanelOptions> panel;  ///< the operator's panel is served
  bool ros2 = false;                  ///< a bridge to ROS 2 even without the table [ros2]
  /// Starts the processes in a random order with random delays (0 to 0.3 s) drawn from this seed: a test of the
  /// barrier.
  std::optional<std::uint64_t> shuffle_seed;
};

}  // namespace mrroc::cli
