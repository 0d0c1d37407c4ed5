#include "cli/commands/command_line.hpp"

#include <memory>

#include "cli/commands/agent_command.hpp"
#include "cli/commands/calibrate_command.hpp"
#include "cli/commands/can_command.hpp"
#include "cli/commands/graph_command.hpp"
#include "cli/commands/keys_command.hpp"
#include "cli/commands/operator_commands.hpp"
#include "cli/commands/panel_command.hpp"
#include "cli/commands/robot_command.hpp"
#include "cli/commands/run_command.hpp"
#include "cli/commands/trace_command.hpp"
#include "command/version.hpp"

namespace mrroc::cli {

void describe_command(CLI::App& app, int& exit_code) {
  app.name("mrroc");
  app.description("MRROC++: program several robots and their sensors as one system");
  app.set_version_flag("--version", command::version_text("mrroc"), "Print the version and exit");
  app.require_subcommand(1);
  add_run_command(app, exit_code);
  add_operator_commands(app, exit_code);
  add_panel_command(app, exit_code);
  add_trace_command(app, exit_code);
  add_graph_command(app, exit_code);
  add_keys_command(app, exit_code);
  add_agent_command(app, exit_code);
  add_can_command(app, exit_code);
  add_robot_command(app, exit_code);
  add_calibrate_command(app, exit_code);
}

void describe_command(CLI::App& app) {
  const auto exit_code = std::make_shared<int>(0);
  describe_command(app, *exit_code);
  app.final_callback([exit_code] {});  // keeps it for as long as the verbs
}

}  // namespace mrroc::cli
