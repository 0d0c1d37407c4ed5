#include "cli/manual/verb_table.hpp"

#include <algorithm>

#include "cli/operator/operator_verbs.hpp"

namespace mrroc::cli {

std::string verb_table() {
  std::string table = "| verb | | effect |\n|---|---|---|\n";
  for (const OperatorVerb& verb : operator_verbs()) {
    table += "| `" + usage_of(verb) + "` | " + (verb.commands ? "*C* " : "") + "| " + std::string{verb.summary};
    for (const VerbArgument& argument : verb.arguments)
      table += ". *" + std::string{argument.name} + "*: " + std::string{argument.summary};
    table += " |\n";
  }
  return table;
}

}  // namespace mrroc::cli
