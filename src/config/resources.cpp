#include "config/resources.hpp"

#include <unistd.h>

#include <cstdlib>
#include <set>
#include <sstream>

namespace mrroc::config {

namespace fs = std::filesystem;

namespace {

constexpr const char* kShare = "MRROC_SHARE";
constexpr const char* kPrograms = "MRROC_PROGRAMS";
constexpr const char* kPlugins = "MRROC_PLUGINS";
constexpr const char* kHost = "MRROC_HOST";

/// The folders that environment variable `name` lists, absolute; else `fallback`.
std::vector<fs::path> folders(const char* name, const std::vector<fs::path>& fallback) {
  const char* value = std::getenv(name);
  std::istringstream list(value != nullptr ? value : "");
  std::vector<fs::path> found;
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) found.push_back(fs::absolute(folder));
  }
  return found.empty() ? fallback : found;
}

void set_list(const char* name, const std::vector<fs::path>& folders) {
  std::string list;
  for (const fs::path& folder : folders) {
    if (!list.empty()) list += ':';
    list += folder.string();
  }
  setenv(name, list.c_str(), 1);
}

/// Of an installation, from the prefix on: the programs that `mrroc run` starts.
constexpr const char* kInstalledPrograms = "libexec/mrroc";

fs::path executable_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

/// The folder that has bin/ or libexec/mrroc/ with the running executable, and share/mrroc/.
fs::path prefix() {
  const fs::path folder = executable_folder();
  const fs::path above = folder.parent_path();
  return folder == above.parent_path() / kInstalledPrograms ? above.parent_path() : above;
}

/// A type is installed if its folder holds its parameter file.
bool holds_type(const fs::path& folder) {
  std::error_code none;
  return fs::is_regular_file(folder / (folder.filename().string() + ".toml"), none);
}

/// Folders with drivers/ and sensors/ of shared libraries.
std::vector<fs::path> plugin_folders() {
  std::vector<fs::path> own{prefix() / "lib" / "mrroc"};
  std::error_code none;
  const fs::path user = user_share();
  if (const fs::path built = user.parent_path().parent_path() / "lib" / "mrroc";
      !user.empty() && fs::is_directory(built, none))
    own.push_back(built);
  return folders(kPlugins, own);
}

/// The share folders for types of this kind. The framework's own drivers are always there: a list of other folders
/// places robots and sensors.
std::vector<fs::path> shares_of(const std::string& kind) {
  std::vector<fs::path> shares = share_directories();
  if (kind == "drivers") shares.push_back(prefix() / "share" / "mrroc");
  return shares;
}

std::vector<std::string> types(const char* kind) {
  std::set<std::string> names;
  for (const fs::path& share : shares_of(kind)) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(share / kind, none)) {
      if (holds_type(entry.path())) names.insert(entry.path().filename().string());
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace

fs::path user_share() {
  const auto folder = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value != nullptr && fs::path(value).is_absolute() ? value : "");
  };
  if (const fs::path data = folder("XDG_DATA_HOME"); !data.empty()) return data / "mrroc";
  const fs::path home = folder("HOME");
  return home.empty() ? home : home / ".local" / "share" / "mrroc";
}

std::vector<fs::path> share_directories() {
  std::vector<fs::path> own{prefix() / "share" / "mrroc"};
  std::error_code none;
  if (const fs::path user = user_share(); fs::is_directory(user, none)) own.push_back(user);
  return folders(kShare, own);
}

std::vector<fs::path> program_directories() {
  std::vector<fs::path> own{executable_folder()};
  const fs::path installed = prefix() / kInstalledPrograms;
  std::error_code none;
  if (own.front() != installed && fs::is_directory(installed, none)) own.push_back(installed);
  return folders(kPrograms, own);
}

fs::path find_program(const std::string& name) {
  for (const fs::path& folder : program_directories())
    if (fs::path program = folder / name; access(program.c_str(), X_OK) == 0) return program;
  return {};
}

std::vector<fs::path> plugin_directories(const std::string& kind) {
  std::vector<fs::path> directories = plugin_folders();
  for (fs::path& folder : directories) folder /= kind;
  return directories;
}

std::vector<std::string> robot_types() { return types("robots"); }

std::vector<std::string> sensor_types() { return types("sensors"); }

std::vector<std::string> driver_names() { return types("drivers"); }

fs::path type_file(const std::string& kind, const std::string& type, const std::string& name) {
  const auto shares = shares_of(kind);
  for (const fs::path& share : shares) {
    if (holds_type(share / kind / type)) return share / kind / type / name;
  }
  return shares.front() / kind / type / name;
}

void hand_down_directories() {
  set_list(kShare, share_directories());
  set_list(kPrograms, program_directories());
  set_list(kPlugins, plugin_folders());
}

std::string this_host() {
  const char* value = std::getenv(kHost);
  return value != nullptr ? value : "";
}

void hand_down_host(const std::string& name) { setenv(kHost, name.c_str(), 1); }

}  // namespace mrroc::config
