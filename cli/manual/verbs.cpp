#include "cli/manual/verbs.hpp"

#include <sstream>

namespace mrroc::cli {

namespace {

void add_verbs(const CLI::App& app, const std::string& words, std::vector<Verb>& verbs) {
  verbs.push_back({words, &app});
  for (const CLI::App* below : verbs_below(app))
    add_verbs(*below, words.empty() ? below->get_name() : words + " " + below->get_name(), verbs);
}

}  // namespace

std::vector<Verb> verbs_of(const CLI::App& app) {
  std::vector<Verb> verbs;
  add_verbs(app, "", verbs);
  return verbs;
}

std::vector<const CLI::App*> verbs_below(const CLI::App& app) {
  return app.get_subcommands(
      [](const CLI::App* below) { return !below->get_name().empty() && !below->get_group().empty(); });
}

std::vector<const CLI::Option*> dashed_options(const CLI::App& app) {
  return app.get_options(
      [](const CLI::Option* option) { return option->nonpositional() && !option->get_group().empty(); });
}

std::vector<const CLI::Option*> positional_arguments(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}');
  std::vector<std::string> choices;
  if (open == std::string::npos || close == std::string::npos) return choices;
  std::istringstream list(type.substr(open + 1, close - open - 1));
  for (std::string choice; std::getline(list, choice, ',');) choices.push_back(choice);
  return choices;
}

}  // namespace mrroc::cli
