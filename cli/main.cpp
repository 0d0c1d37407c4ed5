#include <signal.h>
#include <unistd.h>

#include <exception>
#include <string>

#include "cli/commands/command_line.hpp"
#include "cli/output/output.hpp"
#include "clock/wall/monotonic.hpp"
#include "command/parse_command.hpp"
#include "command/printable.hpp"
#include "mrroc/errors.hpp"
#include "process/exit_code.hpp"
#include "process/standard_files.hpp"

namespace {

using mrroc::process::ExitCode;

constexpr std::int64_t kPatienceWithReader = 2 * mrroc::clock::kSecond;

/// The signals stay blocked after a run: an error must not wait for a reader that has stopped.
int fail(ExitCode code, const std::exception& error) {
  mrroc::cli::Output err(STDERR_FILENO);
  err.write("mrroc: " + mrroc::command::printable_lines(error.what()) + "\n");
  err.drain(mrroc::clock::monotonic_ns() + kPatienceWithReader);
  return static_cast<int>(code);
}

}  // namespace

int main(int argc, char** argv) {
  mrroc::process::open_standard_files();
  signal(SIGCHLD, SIG_DFL);  // ignored, it would be inherited, and no child could be waited for
  signal(SIGXFSZ, SIG_IGN);  // a file size limit is an error of the write
  try {
    CLI::App app;
    int exit_code = 0;
    mrroc::cli::describe_command(app, exit_code);
    return mrroc::command::parse_command(app, argc, argv).value_or(exit_code);
  } catch (const mrroc::Error& error) {
    return fail(mrroc::process::exit_code(error.error_class()), error);
  } catch (const std::exception& error) {
    return fail(ExitCode::usage, error);
  }
}
