#include "cli/commands/agent_command.hpp"

#include <unistd.h>

#include <memory>

#include "cli/hosts/agent.hpp"
#include "command/number_option.hpp"

namespace mrroc::cli {

void add_agent_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("agent", "Run processes of a deployment here for `mrroc run` elsewhere");
  command->group("");
  auto patience = std::make_shared<double>(Agent::kPatienceWithOrder);
  command::add_number(*command, "--order-within", *patience, 0.0, 1e6, "Timeout for the order, s")
      ->capture_default_str();
  command->callback(
      [&exit_code, patience] { exit_code = static_cast<int>(Agent(STDIN_FILENO, STDOUT_FILENO, *patience).run()); });
}

}  // namespace mrroc::cli
