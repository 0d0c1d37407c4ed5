#pragma once

#include <filesystem>
#include <string>

namespace mrroc::cli {

/// The command that runs the demo of a new robot type in this folder. Where a run does not look for types, it gives the
/// run that folder; where none can be found, because the folder above it is not `robots`, it says so. Any thread.
std::string demo_command(const std::filesystem::path& type);

}  // namespace mrroc::cli
