#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc robot show FILE.urdf`: what the framework makes of an arm that a URDF describes.
void add_robot_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
