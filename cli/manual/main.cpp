#include <cstdio>
#include <exception>
#include <string>

#include "cli/commands/command_line.hpp"
#include "cli/manual/bash_completion.hpp"
#include "cli/manual/manual_page.hpp"
#include "cli/manual/verb_table.hpp"

/// Prints the text made from the description of the command `mrroc`: `mrroc_manual man` or `mrroc_manual bash`; the
/// table of the operator's verbs: `mrroc_manual verbs`.
int main(int count, char** arguments) try {
  const std::string kind = count == 2 ? arguments[1] : "";
  CLI::App app;
  mrroc::cli::describe_command(app);
  if (kind == "man") {
    std::fputs(mrroc::cli::manual_page(app, MRROC_VERSION).c_str(), stdout);
  } else if (kind == "bash") {
    std::fputs(mrroc::cli::bash_completion(app).c_str(), stdout);
  } else if (kind == "verbs") {
    std::fputs(mrroc::cli::verb_table().c_str(), stdout);
  } else {
    std::fputs("usage: mrroc_manual man|bash|verbs\n", stderr);
    return 2;
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "mrroc_manual: %s\n", error.what());
  return 2;
}
