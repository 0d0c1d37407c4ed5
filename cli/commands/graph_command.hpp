#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc graph`. Its result becomes `exit_code`.
void add_graph_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
