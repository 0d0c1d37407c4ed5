#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc run`. Its result becomes `exit_code`.
void add_run_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
