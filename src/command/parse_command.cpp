#include "command/parse_command.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "command/print.hpp"
#include "command/printable.hpp"
#include "command/version.hpp"
#include "core/nearest_word.hpp"

namespace mrroc::command {

namespace {

constexpr int kUsage = 2;

/// The option `--name` of `app`, or null.
const CLI::Option* option_of(const CLI::App& app, const std::string& name) {
  for (const CLI::Option* option : app.get_options())
    if (option->check_name(name)) return option;
  return nullptr;
}

/// The verb `name` of `app`, or null.
const CLI::App* verb_of(const CLI::App& app, const std::string& name) {
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    if (verb->get_name() == name) return verb;
  return nullptr;
}

/// "-.5", which CLI11 takes for an option.
bool is_short_negative(const std::string& word) {
  return word.size() > 2 && word.starts_with("-.") && std::isdigit(static_cast<unsigned char>(word[2])) != 0;
}

/// CLI11 reports an unknown command as a missing one.
void check_command(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) return;
  std::vector<std::string> known;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); }))
    known.push_back(verb->get_name());
  if (known.empty() || verb_of(app, words.front()) != nullptr) return;
  const std::string nearest = core::nearest_word(words.front(), known);
  throw CLI::ExtrasError(
      "unknown command '" + words.front() + "'" + (nearest.empty() ? "" : ", did you mean '" + nearest + "'?"),
      CLI::ExitCodes::ExtrasError);
}

/// CLI11 reports unknown options together with all words behind them, the last one first.
void check_options(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* verb = &app;
  for (const std::string& word : words) {
    if (word == "--" || verb->get_allow_extras()) return;
    if (const CLI::App* const inner = verb_of(*verb, word)) verb = inner;
    const bool is_long = word.size() > 2 && word.starts_with("--") && std::isalpha(static_cast<unsigned char>(word[2]));
    const std::string name = word.substr(0, word.find('='));
    if (!is_long || option_of(*verb, name) != nullptr) continue;
    std::vector<std::string> known;
    for (const CLI::Option* option : verb->get_options())
      for (const std::string& each : option->get_lnames()) known.push_back("--" + each);
    const std::string nearest = core::nearest_word(name, known);
    throw CLI::ExtrasError("unknown option '" + name + "' of " + verb->get_display_name() +
                               (nearest.empty() ? "" : ", did you mean '" + nearest + "'?"),
                           CLI::ExitCodes::ExtrasError);
  }
}

}  // namespace

std::vector<std::string> words_of(CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> result;
  const CLI::App* verb = &app;
  for (auto word = words.begin(); word != words.end(); ++word) {
    if (*word == "--") {
      result.insert(result.end(), word, words.end());
      break;
    }
    const std::size_t equals = word->find('=');
    const bool is_long = word->starts_with("--") && equals != std::string::npos;
    const CLI::Option* const option = is_long ? option_of(*verb, word->substr(0, equals)) : nullptr;
    if (option != nullptr && option->get_items_expected_max() == 0)
      throw CLI::ArgumentMismatch(word->substr(0, equals) + ": '" + word->substr(equals + 1) + "', expected no value");
    if (option != nullptr && equals + 1 == word->size()) {
      result.push_back(word->substr(0, equals));
      result.emplace_back();
      continue;
    }
    if (const CLI::App* const inner = verb_of(*verb, *word)) verb = inner;
    result.push_back(is_short_negative(*word) ? "-0" + word->substr(1) : *word);
  }
  return result;
}

std::optional<int> parse_command(CLI::App& app, int argc, char** argv) {
  const std::string program = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "";
  if (app.get_name().empty()) app.name(program);
  if (app.get_version_ptr() == nullptr)
    app.set_version_flag("--version", version_text(app.get_name()), "Print the version and exit");
  try {
    std::vector<std::string> words = words_of(app, {argv + std::min(argc, 1), argv + argc});
    check_command(app, words);
    check_options(app, words);
    std::reverse(words.begin(), words.end());  // as CLI11 expects them
    app.parse(std::move(words));
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const bool wrong = app.exit(error, out, err) != 0;
    if (!out.str().empty()) print(out.str());
    if (!err.str().empty()) std::fputs(printable_lines(err.str()).c_str(), stderr);
    return wrong ? kUsage : 0;
  }
}

}  // namespace mrroc::command
