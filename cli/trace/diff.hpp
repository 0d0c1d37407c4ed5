#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/trace/reader.hpp"

namespace mrroc::cli::trace {

/// Where two traces differ first.
struct Difference {
  std::string place;          ///< "process arm, instruction 4 (ToolVelocity), step 12, tick 248"
  std::string field;          ///< "joints of robot arm[2]"; empty: one of the traces has no such step
  std::string first, second;  ///< its values; "missing" where a trace lacks it
};

/// The comparison of two traces.
struct Comparison {
  std::uint64_t steps = 0;               ///< that are equal
  std::optional<Difference> difference;  ///< none: both have the same steps
};

/// Compares the steps of each process in their order, field by field, bit by bit; the order of processes among each
/// other, ends and clocks do not count. Stops at the first difference in the order of the files. Throws what
/// Reader::next throws.
Comparison compare(Reader& first, Reader& second);

}  // namespace mrroc::cli::trace
