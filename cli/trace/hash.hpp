#pragma once

#include <filesystem>
#include <string>

namespace mrroc::cli::trace {

/// The hash of the steps of a recording.
struct Hash {
  std::string text;       ///< 16 hexadecimal digits
  bool complete = false;  ///< the run has closed the recording: it was not killed
};

/// FNV-1a (64 bit) of all steps as they are encoded, in their order, and of the numbers of steps at the end of each
/// process: equal runs, equal hashes, whatever else is recorded. Throws std::runtime_error when the file cannot be read
/// or is not a recording, NoSteps.
Hash hash_of(const std::filesystem::path& file);

}  // namespace mrroc::cli::trace
