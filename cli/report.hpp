#pragma once

#include "cli/runner.hpp"

namespace mrroc::cli {

/// Prints what a run did: result, simulated and wall time; under the real clock also ticks, missed ticks, late commands
/// and wake-up percentiles of every servo; of every other host, link and clock.
void print_report(const config::Deployment& deployment, const RunResult& result);

}  // namespace mrroc::cli
