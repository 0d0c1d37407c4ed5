#pragma once

#include <filesystem>
#include <string>

namespace mrroc::config {

/// Why `file` cannot be read: "does not exist", "is a directory", "is not a regular file", "cannot be read: <reason of
/// the system>". Empty if it can.
std::string reading_problem(const std::filesystem::path& file);

/// The bytes of a regular file. Throws ConfigurationError if it cannot be read.
std::string read_file(const std::filesystem::path& file);

}  // namespace mrroc::config
