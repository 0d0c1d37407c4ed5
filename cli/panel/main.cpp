// mrroc_panel: serves the operator's panel of a run to browsers.
#include <signal.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/panel/run_feed.hpp"
#include "cli/panel/scene.hpp"
#include "command/number_option.hpp"
#include "command/parse_command.hpp"
#include "command/print.hpp"
#include "command/printable.hpp"
#include "config/resources.hpp"
#include "links/transport/network_interface.hpp"
#include "process/standard_files.hpp"

namespace mrroc::cli {
namespace {

struct PanelArguments {
  std::string run;     ///< deployment, or deployment-pid; empty: the only run
  std::string socket;  ///< instead of `run`
  std::string interface;
  PanelAddress address;
};

/// SIGTERM, SIGINT and SIGHUP as a descriptor, for all threads.
int stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, number);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signalfd(-1, &signals, SFD_CLOEXEC);
}

PanelAddress address_of(const PanelArguments& arguments) {
  PanelAddress address = arguments.address;
  if (arguments.interface.empty()) return address;
  const links::NetworkInterface interface = links::find_interface(arguments.interface);
  if (!interface.loopback && address.certificate.empty())
    throw std::runtime_error("--interface " + arguments.interface +
                             ": other machines reach it, and anyone between could read the token and command the "
                             "robots, expected --certificate with a PEM file for TLS");
  address.address = interface.address;
  return address;
}

/// Without the deployment's file there is no 3D view; the rest works.
std::optional<WorldView> view_of(const config::Deployment& deployment) try {
  return std::optional<WorldView>(std::in_place, deployment);
} catch (const std::exception& error) {
  std::fprintf(stderr, "mrroc_panel: no 3D view: %s\n", command::printable_lines(error.what()).c_str());
  return std::nullopt;
}

void serve(const PanelArguments& arguments, int stop) {
  const PanelAddress address = address_of(arguments);
  RunConnection run = arguments.socket.empty() ? RunConnection::to(arguments.run) : RunConnection(arguments.socket);
  const auto status = nlohmann::json::parse(run.request("status").data);
  const config::Deployment deployment = config::load_deployment(status.at("file").get<std::string>());
  std::optional<WorldView> view = view_of(deployment);
  CameraPictures pictures(deployment);
  auto files = load_page(config::type_file("panel", "page", "index.html").parent_path());
  const mjModel* const model = view ? &view->model() : nullptr;
  files["scene.json"] = {media_type("scene.json"), scene_json(model, deployment, pictures.cameras()), ""};
  PanelServer server(address, run.path(), std::move(files), pictures);
  command::print("panel: " + server.url(PanelRight::command) + "\n");
  command::print("panel, to watch only: " + server.url(PanelRight::watch) + "\n");
  RunFeed(run, view ? &*view : nullptr, pictures, server).serve(stop);
  // nothing is left to be saved, and a browser that does not read would be waited for
  std::fflush(stdout);
  _exit(0);
}

}  // namespace
}  // namespace mrroc::cli

int main(int argc, char** argv) {
  using namespace mrroc;
  process::open_standard_files();
  signal(SIGPIPE, SIG_IGN);
  try {
    const int stop = cli::stop_signals();
    cli::PanelArguments arguments;
    CLI::App app{"Serves the operator's panel of a run to browsers."};
    app.add_option("DEPLOYMENT", arguments.run, "Name of the deployment, or NAME-PID; default: the only run");
    app.add_option("--socket", arguments.socket, "Socket of the run, instead of its name");
    command::add_number(app, "--port", arguments.address.port, 0, 65535, "Port; 0: any free one");
    app.add_option("--interface", arguments.interface, "Network device or own address; default: this machine only");
    app.add_option("--certificate", arguments.address.certificate, "PEM file with certificate and private key: TLS")
        ->check(CLI::ExistingFile);
    if (const auto exit_code = command::parse_command(app, argc, argv)) return *exit_code;
    cli::serve(arguments, stop);
  } catch (const std::exception& error) {
    std::fflush(stdout);
    std::fprintf(stderr, "mrroc_panel: %s\n", command::printable_lines(error.what()).c_str());
    return 2;
  }
  return 0;
}
