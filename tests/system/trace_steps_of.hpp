#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/trace/line.hpp"

namespace mrroc::test {

using Steps = std::vector<cli::trace::Line>;

/// All steps of a recording, in its order; none when there is no such file.
Steps steps_of(const std::filesystem::path& trace);

/// Those for which `fits` is true.
template <class Fits>
Steps steps_where(const std::filesystem::path& trace, Fits fits) {
  Steps found;
  for (cli::trace::Line& line : steps_of(trace))
    if (fits(line)) found.push_back(std::move(line));
  return found;
}

/// Those of the Moves (and Waits) with this name.
inline Steps steps_of(const std::filesystem::path& trace, const std::string& name) {
  return steps_where(trace, [&name](const cli::trace::Line& line) { return line.name == name; });
}

/// The part of a step with this name; null when it has none.
const cli::trace::RobotEntry* robot_in(const cli::trace::Line& line, const std::string& name);
const cli::trace::SensorEntry* sensor_in(const cli::trace::Line& line, const std::string& name);
const cli::trace::ConditionEntry* condition_in(const cli::trace::Line& line, const std::string& name);

}  // namespace mrroc::test
