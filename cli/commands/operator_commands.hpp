#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// `mrroc VERB [DEPLOYMENT]` for the verbs of the operator's table, and `mrroc list`: they act on runs of this user on
/// this machine.
void add_operator_commands(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
