#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// `mrroc trace plot FILE SIGNAL...`: draws signals of a recording, and prints their extremes.
void add_plot_command(CLI::App& trace, int& exit_code);

}  // namespace mrroc::cli
