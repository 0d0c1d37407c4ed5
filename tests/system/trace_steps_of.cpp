#include "system/trace_steps_of.hpp"

#include "cli/trace/reader.hpp"

namespace mrroc::test {

namespace {

template <class Entry>
const Entry* entry_in(const std::vector<Entry>& entries, const std::string& name) {
  for (const Entry& entry : entries)
    if (entry.name == name) return &entry;
  return nullptr;
}

}  // namespace

Steps steps_of(const std::filesystem::path& trace) {
  Steps steps;
  if (!std::filesystem::exists(trace)) return steps;
  cli::trace::Reader reader(trace);
  for (auto item = reader.next(); !std::holds_alternative<std::monostate>(item); item = reader.next())
    if (auto* const line = std::get_if<cli::trace::Line>(&item)) steps.push_back(std::move(*line));
  return steps;
}

const cli::trace::RobotEntry* robot_in(const cli::trace::Line& line, const std::string& name) {
  return entry_in(line.robots, name);
}

const cli::trace::SensorEntry* sensor_in(const cli::trace::Line& line, const std::string& name) {
  return entry_in(line.sensors, name);
}

const cli::trace::ConditionEntry* condition_in(const cli::trace::Line& line, const std::string& name) {
  return entry_in(line.conditions, name);
}

}  // namespace mrroc::test
