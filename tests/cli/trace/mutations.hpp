#pragma once

#include <functional>
#include <optional>
#include <random>

#include "cli/trace/trace_steps.hpp"

namespace mrroc::cli::trace {

using Random = std::mt19937_64;

/// A mutation of a trace that keeps every rule. It is applied where the rules can detect it; each mutation documents
/// why they cannot detect it elsewhere.
struct Mutation {
  const char* name;
  /// Changes the trace at a random place; false: it has no suitable place.
  std::function<bool(TraceSteps&, Random&)> apply;
};

/// Mutations of the lines as such: which there are, their order, their names.
std::vector<Mutation> mutations_of_lines();
/// Mutations of the commands of robots, and of their answers.
std::vector<Mutation> mutations_of_robots();
/// Mutations of readings, conditions and endings.
std::vector<Mutation> mutations_of_conditions();

std::vector<Mutation> all_mutations();

inline constexpr std::size_t kNoLine = ~std::size_t{0};

/// The line of the step before, or behind, in the same instruction; kNoLine when it does not exist.
std::size_t line_before(const TraceSteps& trace, std::size_t i);
std::size_t line_behind(const TraceSteps& trace, std::size_t i);

std::uint64_t pick(Random& random, std::uint64_t first, std::uint64_t last);

/// Any line for which `suits` is true.
std::optional<std::size_t> pick_line(const TraceSteps& trace, Random& random,
                                     const std::function<bool(std::size_t)>& suits);

/// Any robot of any line for which `suits` is true.
struct RobotPlace {
  std::size_t line, robot;
};
std::optional<RobotPlace> pick_robot(const TraceSteps& trace, Random& random,
                                     const std::function<bool(std::size_t, std::size_t)>& suits);

}  // namespace mrroc::cli::trace
