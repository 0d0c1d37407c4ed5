#include "cli/robot/import/mesh_paths.hpp"

#include <cstdlib>
#include <sstream>

#include "config/table.hpp"
#include "config/text/message_text.hpp"

namespace mrroc::cli {

namespace fs = std::filesystem;
using config::ConfigurationError;
using config::in_quotes;

namespace {

constexpr const char* kMesh = "<mesh> filename";

std::vector<fs::path> folders_above(const fs::path& file) {
  std::vector<fs::path> folders;
  for (fs::path folder = file.parent_path();; folder = folder.parent_path()) {
    folders.push_back(folder);
    if (folder == folder.parent_path()) return folders;
  }
}

std::vector<fs::path> listed_in(const char* variable) {
  const char* const value = std::getenv(variable);
  std::istringstream list(value != nullptr ? value : "");
  std::vector<fs::path> folders;
  for (std::string folder; std::getline(list, folder, ':');)
    if (!folder.empty()) folders.emplace_back(folder);
  return folders;
}

bool is_file(const fs::path& file) {
  std::error_code none;
  return fs::is_regular_file(file, none);
}

bool is_folder(const fs::path& folder) {
  std::error_code none;
  return fs::is_directory(folder, none);
}

}  // namespace

MeshPaths::MeshPaths(const fs::path& urdf, Findings& findings)
    : urdf_(fs::absolute(urdf).lexically_normal()), findings_(findings) {}

fs::path MeshPaths::find(const std::string& reference, int line) {
  if (reference.find("${") != std::string::npos || reference.find("$(") != std::string::npos)
    throw ConfigurationError(urdf_, line, kMesh, in_quotes(reference) + " is a xacro expression",
                             "the URDF that the command xacro makes of this file");
  for (const char* const scheme : {"package://", "model://"})
    if (reference.starts_with(scheme))
      return in_package(reference, reference.substr(std::string_view(scheme).size()), line);
  const std::string plain = reference.starts_with("file://") ? reference.substr(7) : reference;
  fs::path file = (urdf_.parent_path() / plain).lexically_normal();
  if (!is_file(file))
    throw ConfigurationError(urdf_, line, kMesh, in_quotes(reference) + ": no file " + file.string(), "a mesh");
  return file;
}

std::vector<fs::path> MeshPaths::package_folders(const std::string& package) const {
  std::vector<fs::path> found;
  const auto add = [&](const fs::path& folder) {
    if (is_folder(folder)) found.push_back(folder);
  };
  for (const fs::path& folder : folders_above(urdf_)) {
    if (folder.filename() == package) add(folder);
    add(folder / package);
  }
  for (const fs::path& folder : listed_in("ROS_PACKAGE_PATH")) {
    if (folder.filename() == package) add(folder);
    add(folder / package);
  }
  for (const fs::path& folder : listed_in("AMENT_PREFIX_PATH")) add(folder / "share" / package);
  return found;
}

fs::path MeshPaths::in_package(const std::string& reference, const fs::path& path, int line) {
  const std::string package = path.empty() ? "" : path.begin()->string();
  const fs::path rest = path.lexically_relative(package);
  const std::vector<fs::path> folders = package_folders(package);
  for (const fs::path& folder : folders)
    if (is_file(folder / rest)) return (folder / rest).lexically_normal();
  for (const fs::path& folder : folders_above(urdf_)) {
    if (!is_file(folder / rest)) continue;
    findings_.warn("the package is not found; its files are taken from " + folder.string(), in_quotes(package), line);
    return (folder / rest).lexically_normal();
  }
  if (folders.empty())
    throw ConfigurationError(
        urdf_, line, kMesh,
        in_quotes(reference) + ": no folder " + in_quotes(package) + " above the file or in ROS_PACKAGE_PATH",
        "the package's folder in ROS_PACKAGE_PATH");
  throw ConfigurationError(urdf_, line, kMesh,
                           in_quotes(reference) + ": no file " + (folders.front() / rest).lexically_normal().string(),
                           "a mesh");
}

}  // namespace mrroc::cli
