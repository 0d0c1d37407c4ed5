#include "cli/commands/graph_command.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "cli/processes/ask_programs.hpp"
#include "cli/processes/child.hpp"
#include "command/print.hpp"
#include "config/deployment.hpp"
#include "config/state_machine.hpp"
#include "config/table.hpp"
#include "config/text/deployment_text.hpp"
#include "config/text/message_text.hpp"
#include "process/record/text_memory.hpp"

namespace mrroc::cli {

namespace {

/// The path of the program of this name in the folders of PATH.
std::filesystem::path find_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::filesystem::path program = std::filesystem::path(folder) / name;
    if (access(program.c_str(), X_OK) == 0) return program;
  }
  throw std::runtime_error("graph: no program '" + name +
                           "': install Graphviz, or leave --output away to get its input");
}

/// Draws it with Graphviz; the file's extension is the format.
void draw(const std::string& dot, const std::filesystem::path& picture) {
  const std::string format = "-T" + (picture.has_extension() ? picture.extension().string().substr(1) : "svg");
  const process::TextMemory input(dot);
  Child child("dot", find_program("dot"),
              {format, "-o", picture.string(), "/proc/self/fd/" + std::to_string(input.fd())}, -1, {input.fd()});
  const std::string output = child.wait_for_output();
  if (child.exit_code() != 0) throw std::runtime_error("graph: " + picture.string() + " could not be drawn: " + output);
}

int graph(const std::filesystem::path& file, const std::filesystem::path& picture) {
  const config::DeploymentText source = config::read_deployment_text(file);
  const config::Deployment deployment = config::load_deployment(source.is_file ? file : source.file, source.text);
  if (deployment.mp.states.empty())
    throw config::ConfigurationError(file, 0, "mp.states", "is missing: there is no state machine to draw",
                                     "the state machine's file");
  const std::string dot =
      config::to_dot(config::load_state_machine(deployment.mp.states, deployment, ask_programs(deployment)));
  if (picture.empty())
    command::print(dot);
  else
    draw(dot, picture);
  return 0;
}

}  // namespace

void add_graph_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("graph", "Draw the state machine of a deployment");
  auto file = std::make_shared<std::filesystem::path>();
  auto picture = std::make_shared<std::filesystem::path>();
  command->add_option("FILE", *file, "Deployment file (TOML)")->required();
  command->add_option("--output,-o", *picture, "Picture: .svg, .png, .pdf; without it the graph is printed (DOT)");
  command->callback([file, picture, &exit_code] { exit_code = graph(*file, *picture); });
}

}  // namespace mrroc::cli
