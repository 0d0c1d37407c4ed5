#include "cli/agent_command.hpp"

#include <unistd.h>

#include "cli/agent.hpp"

namespace mrroc::cli {

void add_agent_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("agent", "Run processes of a deployment here for `mrroc run` elsewhere");
  command->group("");
  command->callback([&exit_code] { exit_code = static_cast<int>(Agent(STDIN_FILENO, STDOUT_FILENO).run()); });
}

}  // namespace mrroc::cli
