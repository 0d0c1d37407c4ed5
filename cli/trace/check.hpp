#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "cli/trace/rule.hpp"

namespace mrroc::cli::trace {

/// The result of a check.
struct Verdict {
  std::uint64_t lines = 0;         ///< steps
  std::uint64_t instructions = 0;  ///< of all processes
  std::size_t processes = 0;       ///< that have moved or waited
  std::size_t rules = 0;           ///< that were checked
  std::uint64_t violations = 0;
  /// Notes about a killed process or dropped steps, which are not violations but leave something open. With the file
  /// and the message.
  std::vector<std::string> notes;
  bool complete = false;  ///< the run has closed the recording: it was not killed
};

/// Reads a recording once, step by step, and checks every step with every rule. `report` receives each violation as
/// soon as it is certain, as "FILE:MESSAGE: rule: found, expected ..."; messages count from 1. Memory does not grow
/// with the length of the recording. Throws std::runtime_error when the file cannot be read or a message is wrong.
Verdict check_trace(const std::filesystem::path& file, const std::function<void(const std::string&)>& report);

/// Every rule with the equation it states, one per step.
std::string text_of_rules();

}  // namespace mrroc::cli::trace
