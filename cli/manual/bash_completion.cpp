#include "cli/manual/bash_completion.hpp"

#include <sstream>

#include "cli/manual/verbs.hpp"

namespace mrroc::cli {

namespace {

/// "--help --clock": the options that may follow the verb; an option with a long name is listed without its short one.
std::string words_after(const CLI::App& app) {
  std::string words;
  const auto add = [&words](const std::string& word) { words += (words.empty() ? "" : " ") + word; };
  for (const CLI::App* below : verbs_below(app)) add(below->get_name());
  for (const CLI::Option* option : dashed_options(app)) {
    for (const std::string& name : option->get_lnames()) add("--" + name);
    if (option->get_lnames().empty()) add("-" + option->get_snames().front());
  }
  return words;
}

/// Cases "run --clock": the values of an option of a verb.
void write_choices(std::ostream& out, const Verb& verb) {
  for (const CLI::Option* option : dashed_options(*verb.app)) {
    std::string values;
    for (const std::string& choice : choices_of(*option)) values += (values.empty() ? "" : " ") + choice;
    if (values.empty()) continue;
    for (const std::string& name : option->get_lnames())
      out << "    \"" << verb.words << " --" << name << "\") COMPREPLY=($(compgen -W \"" << values
          << "\" -- \"$word\")); return ;;\n";
  }
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  const std::string& command = app.get_name();
  const std::vector<Verb> verbs = verbs_of(app);
  std::ostringstream out;
  out << "# bash completion of " << command << ", made from its own description\n_" << command << "() {\n"
      << "  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} verb= words= next i\n"
      << "  for ((i = 1; i < COMP_CWORD; ++i)); do\n    next=\"${verb:+$verb }${COMP_WORDS[i]}\"\n    case $next in\n";
  for (const Verb& verb : verbs)
    if (!verb.words.empty()) out << "      \"" << verb.words << "\") verb=$next ;;\n";
  out << "    esac\n  done\n  case \"$verb $previous\" in\n";
  for (const Verb& verb : verbs) write_choices(out, verb);
  out << "  esac\n  case $verb in\n";
  for (const Verb& verb : verbs) out << "    \"" << verb.words << "\") words=\"" << words_after(*verb.app) << "\" ;;\n";
  out << "  esac\n  case \"$verb $word\" in\n    *\\ -*) COMPREPLY=($(compgen -W \"$words\" -- \"$word\")) ;;\n";
  for (const Verb& verb : verbs)
    if (!verbs_below(*verb.app).empty())
      out << "    \"" << verb.words << " $word\") COMPREPLY=($(compgen -W \"$words\" -- \"$word\")) ;;\n";
  // without an answer bash completes file names
  out << "  esac\n}\ncomplete -o default -F _" << command << " " << command << "\n";
  return out.str();
}

}  // namespace mrroc::cli
