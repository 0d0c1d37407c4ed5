#include "cli/trace/rule.hpp"

namespace mrroc::cli::trace {

Rules all_rules() {
  Rules all;
  for (const Rules& part : {rules_of_lines(), rules_of_instructions(), rules_of_endings(), rules_of_commands(),
                            rules_of_answers(), rules_of_sensors(), rules_of_coordination()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace mrroc::cli::trace
