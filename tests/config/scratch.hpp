#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "config/table.hpp"

namespace mrroc::config {

/// A folder of its own for one test, removed at the end.
class Scratch {
 public:
  Scratch() {
    std::string pattern = (std::filesystem::temp_directory_path() / "mrroc_config_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~Scratch() { std::filesystem::remove_all(folder_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

  /// Writes the file, making its folders, and returns its path.
  std::filesystem::path write(const std::filesystem::path& name, std::string_view text) const {
    const auto file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

 private:
  std::filesystem::path folder_;
};

/// Message of the ConfigurationError that `action` throws, with `folder/` taken off; "" if it throws none.
template <typename Action>
std::string message_of(const std::filesystem::path& folder, Action action) {
  try {
    action();
    return "";
  } catch (const ConfigurationError& error) {
    std::string message = error.what();
    const std::string prefix = folder.string() + "/";
    return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
  }
}

}  // namespace mrroc::config
