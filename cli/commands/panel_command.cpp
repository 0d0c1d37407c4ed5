#include "cli/commands/panel_command.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/become_program.hpp"
#include "cli/run/panel_options.hpp"
#include "command/number_option.hpp"

namespace mrroc::cli {

namespace {

struct PanelRequest {
  std::string deployment;
  PanelOptions options;
};

[[noreturn]] void become_server(const PanelRequest& request) {
  std::vector<std::string> words = panel_arguments(request.options);
  if (!request.deployment.empty()) words.push_back(request.deployment);
  become_program(panel_program(), std::move(words));
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
