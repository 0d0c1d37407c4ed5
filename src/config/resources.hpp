#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mrroc::config {

/// Where robots/<type>/ and sensors/<type>/ with their data files lie: $MRROC_SHARE, else share/mrroc beside the bin
/// folder of the running executable (the build tree has the layout of an installation).
std::filesystem::path share_directory();

/// Folder of executables: that of the running one.
std::filesystem::path program_directory();

/// Names of the installed robot (sensor) types, sorted.
std::vector<std::string> robot_types();
std::vector<std::string> sensor_types();

}  // namespace mrroc::config
