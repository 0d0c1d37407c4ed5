#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc keys`. Its result becomes `exit_code`.
void add_keys_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
