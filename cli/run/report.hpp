#pragma once

#include <string>

#include "cli/run/run_result.hpp"
#include "config/deployment.hpp"

namespace mrroc::cli {

/// Lines about a run: result, simulated and wall time; under the real clock also ticks, missed ticks, late commands and
/// wake-up percentiles of every servo; of every other host, link and clock. Without the end of the last line.
std::string report_of(const config::Deployment& deployment, const RunResult& result);

}  // namespace mrroc::cli
