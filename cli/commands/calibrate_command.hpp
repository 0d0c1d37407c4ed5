#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc calibrate KIND DEPLOYMENT`: runs the program calibrate_KIND as the task of one robot of the deployment.
/// Its result becomes `exit_code`.
void add_calibrate_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
