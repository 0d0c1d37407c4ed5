#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mrroc::process {

/// The command line with which the runner starts a process: written by `to_command_line`, read by `parse_arguments`.
struct Arguments {
  std::filesystem::path deployment;
  int deployment_fd = -1;  ///< its text, read by the runner (memfd, inherited); -1: in the file
  std::string name;        ///< of the process, e.g. `arm` (ECP), `arm_edp`, `wrist`
  int clock_fd = -1;       ///< memory of the clock (memfd, inherited)
  int world_fd = -1;       ///< memory of the simulated world; -1: no simulator
  int domain = 0;          ///< DDS domain
  int record_fd = -1;      ///< memory that carries its steps (StepRing) or servo ticks to the recording; -1: none
  std::string behaviours;  ///< of every ECP program, for the MP of a state machine (config::ProgramsByRobot)
  std::filesystem::path black_box;  ///< folder for the black box of a task that fails; empty: not written
  int black_box_fd = -1;            ///< memory of its last steps (SharedBlackBox, inherited); -1: not kept
  int picture_fd = -1;              ///< memory of its pictures (PictureMemory, inherited; VSPs only); -1: not shown
  std::filesystem::path snapshots;  ///< folder for world snapshots (sim only); may be empty
  std::filesystem::path motion;     ///< file for the motion of the world's robots (sim only); may be empty
  int motion_fd = -1;               ///< the same, open (inherited)
  std::vector<std::string> faults;  ///< to be injected into the run, see faults::parse_fault
  // as in links::DomainOptions
  std::string interface;           ///< device or own address by which the peers are reached; empty: loopback
  std::vector<std::string> peers;  ///< names or addresses of the machines that take part; empty: this one
  std::filesystem::path keys;      ///< folder of the deployment's keys; empty: no DDS Security

  /// The descriptors that are not -1; only this process inherits them.
  std::vector<int> descriptors() const;
};

std::vector<std::string> to_command_line(const Arguments& arguments);

/// The arguments; nothing after --help or --version, which it prints. Throws std::runtime_error with the usage when the
/// program is started by hand, without the runner.
std::optional<Arguments> parse_arguments(int argc, char** argv);

}  // namespace mrroc::process
