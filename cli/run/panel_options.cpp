#include "cli/run/panel_options.hpp"

#include <stdexcept>

#include "config/resources.hpp"

namespace mrroc::cli {

std::vector<std::string> panel_arguments(const PanelOptions& options) {
  std::vector<std::string> words{"--port", std::to_string(options.port)};
  if (!options.interface.empty()) words.insert(words.end(), {"--interface", options.interface});
  if (!options.certificate.empty()) words.insert(words.end(), {"--certificate", options.certificate.string()});
  return words;
}

std::string panel_program() {
  if (const std::filesystem::path program = config::find_program("mrroc_panel"); !program.empty()) return program;
  throw std::runtime_error("the panel is not installed here, expected mrroc_panel of 'make panel'");
}

}  // namespace mrroc::cli
