#include "config/resources.hpp"

#include <algorithm>
#include <cstdlib>

namespace mrroc::config {

namespace fs = std::filesystem;

namespace {

/// The folder that environment variable `name` holds, absolute; else `fallback`.
fs::path folder(const char* name, const fs::path& fallback) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? fs::absolute(value) : fallback;
}

fs::path executable_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

/// A type is installed if its folder holds its parameter file.
std::vector<std::string> types(const char* kind) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(share_directory() / kind, none)) {
    const std::string name = entry.path().filename().string();
    if (fs::is_regular_file(entry.path() / (name + ".toml"), none)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

fs::path share_directory() { return folder("MRROC_SHARE", executable_folder().parent_path() / "share" / "mrroc"); }

fs::path program_directory() { return folder("MRROC_PROGRAMS", executable_folder()); }

std::vector<std::string> robot_types() { return types("robots"); }

std::vector<std::string> sensor_types() { return types("sensors"); }

}  // namespace mrroc::config
