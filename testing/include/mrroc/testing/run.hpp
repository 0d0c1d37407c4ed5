#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mrroc/testing/motion.hpp"
#include "mrroc/types.hpp"

namespace mrroc::task_test {

/// One step of a Move or Wait, as it is recorded (docs/reference/recording.md).
struct Step {
  Tick tick = 0;
  std::string process;      ///< the process that runs the instruction
  std::string instruction;  ///< name of the generator, or of the condition waited for
  bool is_move = false;
  std::uint64_t step = 0;  ///< of the instruction, from 0
  std::string ending;      ///< why the instruction ends here; empty: it continues
  std::string json;        ///< the whole step, as `mrroc trace cat` prints its message
};

/// Results of a run.
struct RunResult {
  int exit_code = 0;        ///< of `mrroc run`; minus the signal that has ended it
  std::string output;       ///< stdout and stderr
  std::string error;        ///< the line with the reason of the end: "mrroc: <deployment>: ..."; may be empty
  std::vector<Step> steps;  ///< of all task processes, in the order of the recording
  std::map<std::string, Motion> motion;  ///< of every robot of the simulated world
  std::map<std::string, Tick> injected;  ///< when each fault was injected; faults that never occurred are absent
  std::vector<std::string> leftovers;    ///< processes that outlived the run: "<pid> <command>"; they have been killed

  /// The steps of one process.
  std::vector<Step> steps_of(const std::string& process) const;
  /// The steps at which an instruction ends.
  std::vector<Step> endings() const;
};

/// Runs a deployment with `mrroc run`, in lockstep unless an option selects another clock, with faults injected, and
/// returns the results. One thread.
class DeploymentRun {
 public:
  /// `command`: the `mrroc` program.
  DeploymentRun(std::filesystem::path command, std::filesystem::path deployment);

  /// "kill ecp:arm at step 120": docs/how-to/fault-injection.md.
  DeploymentRun& inject(std::string fault);
  /// Further arguments of `mrroc run`, one word each.
  DeploymentRun& option(std::string word);
  /// Starts the deployment and waits for its end; kills it after `patience` s. Throws std::runtime_error when it cannot
  /// be started or its files cannot be read.
  RunResult run(int patience = 120);

 private:
  std::filesystem::path command_, deployment_;
  std::vector<std::string> faults_, options_;
};

}  // namespace mrroc::task_test
