#pragma once

#include <set>
#include <string>
#include <variant>
#include <vector>

#include "cli/trace/check.hpp"

namespace mrroc::cli::trace {

using Item = std::variant<Line, ProcessEnd>;

/// The steps of a recording in memory, to be changed and written.
struct TraceSteps {
  std::string clock = "lockstep";
  bool black_box = false;
  std::vector<Item> items;

  Line& line(std::size_t i) { return std::get<Line>(items.at(i)); }
  const Line& line(std::size_t i) const { return std::get<Line>(items.at(i)); }
  bool is_line(std::size_t i) const { return std::holds_alternative<Line>(items.at(i)); }
  /// Writes them as a recording.
  void write(const std::filesystem::path& file) const;
};

/// Reads all steps of a recording. Throws what Reader throws.
TraceSteps read_trace(const std::filesystem::path& file);

/// How many lines this process has in a trace.
std::size_t line_count(const TraceSteps& whole, const std::string& process);
/// Its lines from the `begin`-th to before the `end`-th, as if they were its black box.
TraceSteps black_box_of(const TraceSteps& whole, const std::string& process, std::size_t begin, std::size_t end);

/// The result of a check of such a recording.
struct Found {
  Verdict verdict;
  std::vector<std::string> violations;
  std::set<std::string> rules;  ///< names of the violated rules
  std::string malformed;        ///< the error that was thrown; empty: there was none
  std::string text() const;
};
Found check(const TraceSteps& trace);
Found check(const std::filesystem::path& file);

/// A trace that keeps every rule and contains every case: two processes, instructions with one robot, several robots
/// and none, published, polled and interactive sensors with periods, conditions alone and combined, joint, pose and
/// force commands, holds in between, every way to end.
TraceSteps example_trace();

}  // namespace mrroc::cli::trace
