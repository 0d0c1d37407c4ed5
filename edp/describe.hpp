#pragma once

#include <string_view>

#include "edp/shell.hpp"

namespace mrroc::edp {

/// Prints data of an EDP's robot instead of running it: `irb6_edp limits`, `irb6_edp workspace --points 20000`.
///
///   limits [--parameters FILE] Markdown table of the axes' limits
///   workspace [--points N] [--seed S] [--model NAME] [--parameters FILE]
///                              N tool positions (x y z, m, a line each) of joints evenly distributed within joint and
///                              motor limits (within one turn where a joint has no limits)
///
/// FILE is read in place of the type's own. Returns the exit code of the process: 0, or another one for wrong
/// arguments, which it reports on stderr.
int describe(int argc, char** argv, const ModelFactory& factory);

/// Whether `argument` is one of the above.
bool describes(std::string_view argument) noexcept;

}  // namespace mrroc::edp
