#pragma once

#include <CLI/CLI.hpp>

namespace mrroc::cli {

/// Adds `mrroc robot add`, `show` and `check`: the program mrroc_robot, which links MuJoCo and the readers of meshes,
/// takes the place of this process.
void add_robot_command(CLI::App& app, int& exit_code);

}  // namespace mrroc::cli
