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
  /// Notes about a killed process or dropped lines, which are not violations but leave something open. With the file
  /// and the line.
  std::vector<std::string> notes;
};

/// Reads a trace once, line by line, and checks every line with every rule. `report` receives each violation as soon as
/// it is certain, as "FILE:LINE: rule: found, expected ...". Memory does not grow with the trace's length. Throws
/// std::runtime_error when the file cannot be read or a line does not follow the format.
Verdict check_trace(const std::filesystem::path& file, const std::function<void(const std::string&)>& report);

/// The same of a trace in memory; `name`: of its file in messages.
Verdict check_trace(const std::filesystem::path& name, std::string text,
                    const std::function<void(const std::string&)>& report);

/// Every rule with the equation it states, one per line.
std::string text_of_rules();

}  // namespace mrroc::cli::trace
