#pragma once

#include <filesystem>
#include <string>

#include "config/table.hpp"

/// Files that a deployment names; relative paths start at the folder of the deployment file.
namespace mrroc::config {

/// The file that text `key` names, absolute. Throws ConfigurationError if the key is missing or the file cannot be
/// read.
std::filesystem::path require_file(const Table& table, std::string_view key);

/// The absolute path of `name` in `file`: a relative path starts at the folder of the file.
std::filesystem::path beside(const std::filesystem::path& file, const std::filesystem::path& name);

/// The executable `program`, absolute: a plain name is searched in `program_directories()`, one with a `/` is a path.
/// Throws ConfigurationError at `key` if it does not exist or may not be executed.
std::string require_program(const Table& table, std::string_view key, const std::string& program);

/// The plug-in NAME.so of KIND, `drivers` or `sensors`, in one of `plugin_directories(KIND)`, absolute. Throws
/// ConfigurationError at `key` if it is in none.
std::filesystem::path require_library(const Table& table, std::string_view key, const std::string& kind,
                                      const std::string& name);

}  // namespace mrroc::config
