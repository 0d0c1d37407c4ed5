#include "cli/commands/robot_command.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/commands/become_program.hpp"
#include "cli/robot/robot_verbs.hpp"
#include "config/resources.hpp"

namespace mrroc::cli {

namespace {

constexpr const char* kProgram = "mrroc_robot";

std::string robot_program() {
  if (const std::filesystem::path program = config::find_program(kProgram); !program.empty()) return program;
  throw std::runtime_error(std::string(kProgram) + " is not installed, expected it beside the programs of mrroc");
}

/// The words of a parsed verb.
std::vector<std::string> words_of_verb(const CLI::App& verb) {
  std::vector<std::string> words{verb.get_name()};
  for (const CLI::Option* option : verb.get_options()) {
    if (option->count() == 0) continue;
    if (option->get_positional()) continue;
    const std::string name = "--" + option->get_single_name();
    for (const std::string& value : option->results())
      words.push_back(option->get_expected_max() == 0 ? name : std::string(name).append("=").append(value));
  }
  words.emplace_back("--");
  for (const CLI::Option* option : verb.get_options())
    if (option->get_positional()) words.insert(words.end(), option->results().begin(), option->results().end());
  return words;
}

[[noreturn]] void become_robot_program(const CLI::App& verb) { become_program(robot_program(), words_of_verb(verb)); }

}  // namespace

void add_robot_command(CLI::App& app, int&) {
  CLI::App* const robot = app.add_subcommand("robot", "Make robot types of arms in URDFs, look at them, check them");
  add_robot_verbs(*robot, {.add = [](const CLI::App& verb, const AddRequest&) { become_robot_program(verb); },
                           .show = [](const CLI::App& verb, const ShowRequest&) { become_robot_program(verb); },
                           .check = [](const CLI::App& verb, const CheckRequest&) { become_robot_program(verb); }});
}

}  // namespace mrroc::cli
