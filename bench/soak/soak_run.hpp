#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "soak/resident.hpp"

namespace mrroc::soak {

/// The resident memory of every process at a simulated time.
struct Sample {
  double time = 0;  ///< s
  std::map<std::string, Resident> resident;
};

/// Results of a run.
struct SoakRun {
  int exit_code = 0;                              ///< of `mrroc run`; minus the signal that has ended it
  std::string summary;                            ///< the line with simulated and wall time
  std::vector<Sample> samples;                    ///< one for every lap with the bar
  std::size_t servos = 0;                         ///< EDPs in the report
  std::uint64_t ticks = 0, missed = 0, late = 0;  ///< of all servos
  std::uint64_t steps = 0, skew = 0;              ///< of the MP
  std::uintmax_t trace_bytes = 0;
  std::string hash;    ///< of the steps; empty when the run failed
  long peak = 0;       ///< KiB, the most that any process had at any time, the runner at the end too
  std::string output;  ///< remaining output, for example errors
};

/// Carries the bar forth and back for `seconds` of simulated time in lockstep. Everything that is written is in a
/// folder below `TMPDIR`, which is removed. Throws std::runtime_error when nothing can be written or started.
SoakRun soak(double seconds);

}  // namespace mrroc::soak
