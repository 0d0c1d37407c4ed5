#pragma once

#include <string_view>

#include "mrroc/robot_model.hpp"

namespace mrroc::edp {

/// What an EDP tells about its robot instead of running it: `irb6_edp limits`, `irb6_edp workspace --points 20000`.
///
///   limits                     Markdown table of the axes' limits
///   workspace [--points N] [--seed S] [--model NAME]
///                              N tool positions (x y z, m, a line each) of joints evenly distributed within joint and
///                              motor limits (within one turn where a joint has no limits)
///
/// Returns the exit code of the process: 0, or not for wrong arguments, which it tells on stderr.
int describe(int argc, char** argv, const RobotModels& models);

/// Whether `argument` is one of the above.
bool describes(std::string_view argument) noexcept;

}  // namespace mrroc::edp
