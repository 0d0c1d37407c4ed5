#include "cli/graph_command.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <stdexcept>

#include "config/deployment.hpp"
#include "config/message_text.hpp"
#include "config/state_machine.hpp"
#include "config/table.hpp"

namespace mrroc::cli {

namespace {

/// Has Graphviz draw it; the format is the file's extension.
void draw(const std::string& dot, const std::filesystem::path& picture) {
  const std::string format = "-T" + (picture.has_extension() ? picture.extension().string().substr(1) : "svg");
  int input[2];
  if (pipe(input) != 0) throw std::runtime_error("graph: no pipe");
  const pid_t child = fork();
  if (child == 0) {
    dup2(input[0], STDIN_FILENO);
    close(input[0]);
    close(input[1]);
    execlp("dot", "dot", format.c_str(), "-o", picture.c_str(), nullptr);
    std::fprintf(stderr, "mrroc: 'dot' cannot be started: install Graphviz, or leave --output away to get its input\n");
    _exit(127);
  }
  close(input[0]);
  std::signal(SIGPIPE, SIG_IGN);  // when it has not started, its end says so
  FILE* const file = fdopen(input[1], "w");
  std::fputs(dot.c_str(), file);
  std::fclose(file);
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0) throw std::runtime_error("graph: " + picture.string() + " could not be drawn");
}

int graph(const std::filesystem::path& file, const std::filesystem::path& picture) {
  const config::Deployment deployment = config::load_deployment(file);
  if (deployment.mp.states.empty())
    throw config::ConfigurationError(file, 0, "mp.states", "is missing: there is no state machine to draw",
                                     "the state machine's file");
  const std::string dot = config::to_dot(config::load_state_machine(deployment));
  if (picture.empty())
    std::fputs(dot.c_str(), stdout);
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
