// mrroc_render: a picture of a state that the simulation has saved.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "command/number_option.hpp"
#include "command/parse_command.hpp"
#include "command/printable.hpp"
#include "config/deployment.hpp"
#include "process/standard_files.hpp"
#include "sim/removed_material.hpp"
#include "sim/rendering/camera.hpp"
#include "sim/simulation.hpp"
#include "sim/state_file.hpp"

namespace {

mrroc::sim::WorldState home_state(const mrroc::config::Deployment& deployment) {
  const auto memory = std::make_unique<mrroc::world::WorldMemory>();
  return mrroc::sim::Simulation(deployment, *memory).state();
}

}  // namespace

int main(int argc, char** argv) {
  mrroc::process::open_standard_files();
  signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error of the write
  std::string deployment_file, state_file, camera, out;
  int width = 1280, height = 720;
  try {
    CLI::App app{"Draws a state of a simulated world as a PNG file."};
    app.add_option("--deployment", deployment_file, "deployment file whose world it is")->required();
    app.add_option("--state", state_file, "state that the simulation saved; left out: every robot at home");
    app.add_option("--camera", camera, "named camera of the scene; left out: a view of the whole");
    app.add_option("--out", out, "PNG file to write")->required();
    mrroc::command::add_number(app, "--width", width, 16, 8192, "pixels");
    mrroc::command::add_number(app, "--height", height, 16, 8192, "pixels");
    if (const auto exit_code = mrroc::command::parse_command(app, argc, argv)) return *exit_code;
    const auto deployment = mrroc::config::load_deployment(deployment_file);
    const auto state = state_file.empty() ? home_state(deployment) : mrroc::sim::load_state(state_file);
    const auto model = mrroc::sim::load_model(mrroc::sim::compose(deployment));
    mrroc::sim::remove_material(*model, deployment.sim->scene, state_file, state.tick);
    mrroc::sim::Renderer renderer(*model, width, height);
    mrroc::sim::write_png(out, renderer.render(state.positions, camera));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mrroc_render: %s\n", mrroc::command::printable_lines(error.what()).c_str());
    return 2;
  }
  return 0;
}
