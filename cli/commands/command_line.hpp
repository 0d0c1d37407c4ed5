#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Describes the whole `mrroc` command to `app`: its version, every verb with its options and help. A verb that is
/// parsed runs, and puts its exit code into `exit_code`, which outlives `app`.
void describe_command(CLI::App& app, int& exit_code);

/// The same for what only reads the description: a man page, a completion.
void describe_command(CLI::App& app);

}  // namespace mrroc::cli
