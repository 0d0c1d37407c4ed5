#include <cstdio>
#include <exception>

#include "cli/agent_command.hpp"
#include "cli/can_command.hpp"
#include "cli/graph_command.hpp"
#include "cli/keys_command.hpp"
#include "cli/run_command.hpp"
#include "cli/trace_command.hpp"
#include "config/table.hpp"
#include "mrroc/errors.hpp"
#include "process/exit_code.hpp"

using mrroc::process::ExitCode;

int main(int argc, char** argv) {
  CLI::App app{"MRROC++: program several robots and their sensors as one system"};
  app.require_subcommand(1);
  int exit_code = 0;
  try {
    mrroc::cli::add_run_command(app, exit_code);
    mrroc::cli::add_trace_command(app, exit_code);
    mrroc::cli::add_graph_command(app, exit_code);
    mrroc::cli::add_keys_command(app, exit_code);
    mrroc::cli::add_agent_command(app, exit_code);
    mrroc::cli::add_can_command(app, exit_code);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
  } catch (const mrroc::Error& error) {
    std::fprintf(stderr, "mrroc: %s\n", error.what());
    return static_cast<int>(mrroc::process::exit_code(error.error_class()));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mrroc: %s\n", error.what());
    return static_cast<int>(ExitCode::usage);
  }
  return exit_code;
}
