#pragma once

#include <functional>
#include <optional>
#include <random>

#include "cli/trace/trace_text.hpp"

namespace mrroc::cli::trace {

using Random = std::mt19937_64;

/// One way to spoil a trace that keeps every rule. It is applied where the rules can see it; why they cannot see it
/// elsewhere stands with each.
struct Mutation {
  const char* name;
  /// Spoils the trace at a random place; false: it has none.
  std::function<bool(TraceText&, Random&)> apply;
};

/// Of the lines as such: which there are, in which order, what they are called.
std::vector<Mutation> mutations_of_lines();
/// Of what the robots were commanded, and of their answers.
std::vector<Mutation> mutations_of_robots();
/// Of readings, conditions and endings.
std::vector<Mutation> mutations_of_conditions();

std::vector<Mutation> all_mutations();

inline constexpr std::size_t kNoLine = ~std::size_t{0};

/// The line of the step before, or behind, in the same instruction; kNoLine when there is none.
std::size_t line_before(const TraceText& trace, std::size_t i);
std::size_t line_behind(const TraceText& trace, std::size_t i);

std::uint64_t pick(Random& random, std::uint64_t first, std::uint64_t last);

/// Any line for which `suits` is true.
std::optional<std::size_t> pick_line(const TraceText& trace, Random& random,
                                     const std::function<bool(std::size_t)>& suits);

/// Any robot of any line for which `suits` is true.
struct RobotPlace {
  std::size_t line, robot;
};
std::optional<RobotPlace> pick_robot(const TraceText& trace, Random& random,
                                     const std::function<bool(std::size_t, std::size_t)>& suits);

}  // namespace mrroc::cli::trace
