#include "cli/trace_parts.hpp"

#include <utility>

#include "cli/trace.hpp"

namespace mrroc::cli {

TraceParts::TraceParts(std::filesystem::path trace, const std::vector<PlannedProcess>& processes)
    : trace_(std::move(trace)) {
  if (trace_.empty()) return;
  create_trace(trace_);
  for (const PlannedProcess& process : processes)
    if (const std::filesystem::path part = of(process); !part.empty()) std::filesystem::remove(part);
}

std::filesystem::path TraceParts::of(const PlannedProcess& process) const {
  if (trace_.empty() || !process.has_task) return {};
  return trace_.string() + "." + process.name + ".part";
}

void TraceParts::join(const std::vector<PlannedProcess>& processes, config::ClockMode clock) const {
  if (trace_.empty()) return;
  std::vector<std::filesystem::path> parts;
  for (const PlannedProcess& process : processes) {
    const std::filesystem::path part = of(process);
    if (!part.empty() && std::filesystem::exists(part)) parts.push_back(part);
  }
  merge_traces(parts, trace_, clock);
  for (const std::filesystem::path& part : parts) std::filesystem::remove(part);
}

}  // namespace mrroc::cli
