#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace mrroc::cli {

/// The text of a URDF with every reference to a mesh in `files` replaced by `meshes/NAME.stl`. Lines keep their
/// numbers. Throws config::ConfigurationError when it cannot be read. Configuration time only.
std::string urdf_copy(const std::filesystem::path& urdf, const std::map<std::string, std::string>& files);

}  // namespace mrroc::cli
