#include "cli/trace/mutations.hpp"

namespace mrroc::cli::trace {

namespace {

bool same_instruction(const Line& a, const Line& b) { return a.process == b.process && a.instruction == b.instruction; }

}  // namespace

std::vector<Mutation> all_mutations() {
  std::vector<Mutation> all;
  for (const auto& part : {mutations_of_lines(), mutations_of_robots(), mutations_of_conditions()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::size_t line_before(const TraceSteps& trace, std::size_t i) {
  for (std::size_t k = i; k-- > 0;)
    if (trace.is_line(k) && same_instruction(trace.line(k), trace.line(i))) return k;
  return kNoLine;
}

std::size_t line_behind(const TraceSteps& trace, std::size_t i) {
  for (std::size_t k = i + 1; k < trace.items.size(); ++k)
    if (trace.is_line(k) && same_instruction(trace.line(k), trace.line(i))) return k;
  return kNoLine;
}

std::uint64_t pick(Random& random, std::uint64_t first, std::uint64_t last) {
  return std::uniform_int_distribution<std::uint64_t>(first, last)(random);
}

std::optional<std::size_t> pick_line(const TraceSteps& trace, Random& random,
                                     const std::function<bool(std::size_t)>& suits) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < trace.items.size(); ++i)
    if (trace.is_line(i) && suits(i)) places.push_back(i);
  if (places.empty()) return std::nullopt;
  return places[pick(random, 0, places.size() - 1)];
}

std::optional<RobotPlace> pick_robot(const TraceSteps& trace, Random& random,
                                     const std::function<bool(std::size_t, std::size_t)>& suits) {
  std::vector<RobotPlace> places;
  for (std::size_t i = 0; i < trace.items.size(); ++i) {
    if (!trace.is_line(i)) continue;
    for (std::size_t k = 0; k < trace.line(i).robots.size(); ++k)
      if (suits(i, k)) places.push_back({i, k});
  }
  if (places.empty()) return std::nullopt;
  return places[pick(random, 0, places.size() - 1)];
}

}  // namespace mrroc::cli::trace
