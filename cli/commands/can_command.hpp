#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc can scan` and `mrroc can monitor`. Their result becomes `exit_code`.
void add_can_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
