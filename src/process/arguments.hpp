#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace mrroc::process {

/// How the runner tells a process who it is: written by `to_command_line`, read by `parse_arguments`.
struct Arguments {
  std::filesystem::path deployment;
  std::string name;                 ///< of the process, e.g. `arm` (ECP), `arm_edp`, `wrist`
  int clock_fd = -1;                ///< memory of the clock (memfd, handed down)
  int world_fd = -1;                ///< memory of the simulated world; -1: there is none
  int domain = 0;                   ///< DDS domain
  std::filesystem::path trace;      ///< this process's trace file; empty: no trace
  std::string behaviours;           ///< of every ECP program, for the MP of a state machine (config::ProgramsByRobot)
  std::filesystem::path black_box;  ///< folder for the black box of a task that fails; empty: none is written
  int black_box_fd = -1;            ///< memory of its last steps (SharedBlackBox, handed down); -1: there is none
  std::filesystem::path snapshots;  ///< folder for world snapshots (sim only); empty: none
  std::filesystem::path motion;     ///< file for the motion of the world's robots (sim only); empty: none
  std::vector<std::string> faults;  ///< to be injected into the run, see faults::parse_fault
  // as links::DomainOptions has them
  std::string interface;           ///< device or own address by which the peers are reached; empty: loopback
  std::vector<std::string> peers;  ///< names or addresses of the machines that take part; empty: this one
  std::filesystem::path keys;      ///< folder of the deployment's keys; empty: no DDS Security

  /// Those of clock, world and black box that there are: the process shall get them, and nobody else.
  std::vector<int> descriptors() const;
};

std::vector<std::string> to_command_line(const Arguments& arguments);

/// Throws config::ConfigurationError-like std::runtime_error with usage when called by hand without the runner.
Arguments parse_arguments(int argc, char** argv);

}  // namespace mrroc::process
