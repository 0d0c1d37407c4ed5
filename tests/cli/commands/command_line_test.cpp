#include "cli/commands/command_line.hpp"

#include <gtest/gtest.h>

#include "command/version.hpp"

namespace mrroc::cli::command_line_test {
namespace {

/// Every verb of a command, and those of its verbs.
void collect(const CLI::App& app, std::vector<const CLI::App*>& verbs) {
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    verbs.push_back(verb);
    collect(*verb, verbs);
  }
}

TEST(CommandLine, EveryVerbAndOptionIsDescribed) {
  CLI::App app;
  describe_command(app);
  std::vector<const CLI::App*> verbs;
  collect(app, verbs);
  EXPECT_GE(verbs.size(), 8U);
  for (const CLI::App* verb : verbs) {
    EXPECT_FALSE(verb->get_description().empty()) << verb->get_name();
    for (const CLI::Option* option : verb->get_options())
      EXPECT_FALSE(option->get_description().empty()) << verb->get_name() << " " << option->get_name();
  }
}

TEST(CommandLine, TheVersionIsTheProjects) {
  CLI::App app;
  describe_command(app);
  EXPECT_EQ(app.version(), "mrroc " + std::string{command::version()});
}

}  // namespace
}  // namespace mrroc::cli::command_line_test
