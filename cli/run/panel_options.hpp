#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mrroc::cli {

struct PanelOptions {
  int port = 0;                       ///< 0: any free one
  std::string interface;              ///< network device or own address; empty: this machine only
  std::filesystem::path certificate;  ///< PEM file for TLS; empty: without
};

/// The command line of `mrroc_panel` for these options. Any thread.
std::vector<std::string> panel_arguments(const PanelOptions& options);
/// The path of `mrroc_panel`. Throws std::runtime_error when it is not installed. Any thread.
std::string panel_program();

}  // namespace mrroc::cli
