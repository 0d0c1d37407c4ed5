#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc trace`. Its result becomes `exit_code`.
void add_trace_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
