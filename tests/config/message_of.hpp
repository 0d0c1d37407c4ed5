#pragma once

#include <filesystem>
#include <string>

#include "config/table.hpp"

namespace mrroc::config {

/// Message of the ConfigurationError that `action` throws, without `folder/`; "" if it throws none.
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
