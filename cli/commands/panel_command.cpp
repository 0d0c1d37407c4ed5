#include "cli/commands/panel_command.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/run/panel_process.hpp"
#include "command/number_option.hpp"

namespace mrroc::cli {

namespace {

struct PanelRequest {
  std::string deployment;
  PanelOptions options;
};

/// Becomes the panel's server: no process waits for it.
[[noreturn]] void become_server(const PanelRequest& request) {
  std::vector<std::string> words = panel_arguments(request.options);
  words.insert(words.begin(), panel_program());
  if (!request.deployment.empty()) words.push_back(request.deployment);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(arguments.front(), arguments.data());
  throw std::runtime_error(words.front() + ": " + std::strerror(errno));
}

}  // namespace

void add_panel_command(CLI::App& app, int&) {
  CLI::App* const command = app.add_subcommand("panel", "Serve the operator's panel of a run to browsers");
  auto request = std::make_shared<PanelRequest>();
  command->add_option("DEPLOYMENT", request->deployment, "Name of the deployment, or NAME-PID; default: the only run");
  command::add_number(*command, "--port", request->options.port, 0, 65535, "Port; 0: any free one");
  command->add_option("--interface", request->options.interface,
                      "Network device or own address; default: this machine only");
  command->add_option("--certificate", request->options.certificate,
                      "PEM file with certificate and private key, for TLS");
  command->callback([request] { become_server(*request); });
}

}  // namespace mrroc::cli
