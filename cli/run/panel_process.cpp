#include "cli/run/panel_process.hpp"

#include <poll.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "config/resources.hpp"

namespace mrroc::cli {

namespace {

constexpr int kFarewell = 1000;  // ms

std::vector<std::string> with_socket(const PanelOptions& options, const std::filesystem::path& socket) {
  std::vector<std::string> words = panel_arguments(options);
  words.insert(words.end(), {"--socket", socket.string()});
  return words;
}

}  // namespace

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

PanelProcess::PanelProcess(const PanelOptions& options, const std::filesystem::path& socket, Show show)
    : child_("panel", panel_program(), with_socket(options, socket)), show_(std::move(show)) {}

PanelProcess::~PanelProcess() {
  // the socket has been closed: it ends by itself
  const int handle = child_.output_fd();
  pollfd end{handle, 0, 0};
  if (!child_.ended()) ::poll(&end, 1, kFarewell);
}

void PanelProcess::poll() {
  if (ended_) return;
  const bool over = child_.ended();
  for (const std::string& line : child_.read_lines()) {
    serves_ = serves_ || line.starts_with("panel: ");
    show_(line);
  }
  if (!over) return;
  ended_ = true;
  if (serves_) show_("the panel has ended: " + child_.how_it_ended() + "; the run continues");
}

}  // namespace mrroc::cli
