// mrroc_robot: the program behind `mrroc robot`: robot types of arms in URDFs. It links MuJoCo, the readers of meshes
// and OpenGL, which the process that starts a run does not.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/robot/import/add_robot.hpp"
#include "cli/robot/robot_verbs.hpp"
#include "cli/robot/type/check_type.hpp"
#include "cli/robot/type/show_arm.hpp"
#include "command/parse_command.hpp"
#include "command/print.hpp"
#include "command/printable.hpp"
#include "mrroc/errors.hpp"
#include "process/exit_code.hpp"
#include "process/standard_files.hpp"

namespace {

using mrroc::process::ExitCode;

int report(ExitCode code, const std::exception& error) {
  std::fprintf(stderr, "mrroc: %s\n", mrroc::command::printable_lines(error.what()).c_str());
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  namespace cli = mrroc::cli;
  mrroc::process::open_standard_files();
  signal(SIGCHLD, SIG_DFL);  // ignored, it would be inherited, and no child could be waited for
  signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error of the write
  bool passed = true;
  try {
    CLI::App app{"Robot types of arms in URDFs", "mrroc_robot"};
    cli::add_robot_verbs(
        app,
        {.add = [](const CLI::App&, const cli::AddRequest& request) { mrroc::command::print(cli::add_robot(request)); },
         .show = [](const CLI::App&,
                    const cli::ShowRequest& request) { mrroc::command::print(cli::show_arm(request)); },
         .check =
             [&passed](const CLI::App&, const cli::CheckRequest& request) {
               const auto check = check_type(cli::load_chain_type(request.type), request.postures);
               mrroc::command::print(check_report(check));
               passed = check.passed();
             }});
    if (const auto code = mrroc::command::parse_command(app, argc, argv)) return *code;
  } catch (const mrroc::Error& error) {
    return report(mrroc::process::exit_code(error.error_class()), error);
  } catch (const std::exception& error) {
    return report(ExitCode::usage, error);
  }
  return passed ? 0 : 1;
}
