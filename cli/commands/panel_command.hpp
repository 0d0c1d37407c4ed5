#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc panel`: serves the operator's panel of a deployment that runs.
void add_panel_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
