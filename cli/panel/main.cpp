// mrroc_panel: serves the operator's panel of a run to browsers.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "cli/operator/socket/side_program.hpp"
#include "cli/panel/run_feed.hpp"
#include "cli/panel/scene.hpp"
#include "command/number_option.hpp"
#include "command/print.hpp"
#include "command/printable.hpp"
#include "config/resources.hpp"
#include "links/transport/network_interface.hpp"

namespace mrroc::cli {
namespace {

struct PanelArguments {
  std::string interface;
  PanelAddress address;
};

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

void serve(const PanelArguments& arguments, WatchedRun run, int stop) {
  const PanelAddress address = address_of(arguments);
  std::optional<WorldView> view = view_of(run.deployment);
  CameraPictures pictures(run.deployment, run.camera_files);
  auto files = load_page(config::type_file("panel", "page", "index.html").parent_path());
  const mjModel* const model = view ? &view->model() : nullptr;
  files["scene.json"] = {media_type("scene.json"), scene_json(model, run.deployment, pictures.cameras()), ""};
  PanelServer server(address, run.connection.path(), std::move(files), pictures);
  command::print("panel: " + server.url(PanelRight::command) + "\n");
  command::print("panel, to watch only: " + server.url(PanelRight::watch) + "\n");
  RunFeed(run.connection, view ? &*view : nullptr, pictures, server).serve(stop);
  // nothing is left to be saved, and a browser that does not read would be waited for
  std::fflush(stdout);
  _exit(0);
}

class PanelProgram final : public SideProgram {
 public:
  const char* description() const override { return "Serves the operator's panel of a run to browsers."; }
  void add_options(CLI::App& app) override {
    PanelAddress& address = arguments_.address;
    command::add_number(app, "--port", address.port, 0, 65535, "Port; 0: any free one");
    app.add_option("--interface", arguments_.interface, "Network device or own address; default: this machine only");
    app.add_option("--certificate", address.certificate, "PEM file with certificate and private key: TLS")
        ->check(CLI::ExistingFile);
  }
  void serve(WatchedRun run, int stop) override { cli::serve(arguments_, std::move(run), stop); }

 private:
  PanelArguments arguments_;
};

}  // namespace
}  // namespace mrroc::cli

int main(int argc, char** argv) {
  using namespace mrroc::cli;
  return side_main(argc, argv, [] { return std::unique_ptr<SideProgram>(std::make_unique<PanelProgram>()); });
}
