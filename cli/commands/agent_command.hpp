#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc agent`, which `mrroc run` starts on other hosts; the help does not show it. Its result becomes
/// `exit_code`.
void add_agent_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
