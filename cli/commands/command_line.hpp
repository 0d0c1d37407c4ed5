#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Describes the whole `mrroc` command to `app`: its version, every verb with its options and help. A parsed verb runs
/// and stores its exit code in `exit_code`, which outlives `app`.
void describe_command(CLI::App& app, int& exit_code);

/// The same for a reader of the description alone: the man page, the completion.
void describe_command(CLI::App& app);

}  // namespace mrroc::cli
