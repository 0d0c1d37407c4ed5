#pragma once

#include <string>
#include <vector>

#include "cli/trace/memory.hpp"

namespace mrroc::cli::trace {

struct Rule;

/// A violation of a rule.
struct Violation {
  const Rule* rule = nullptr;
  std::size_t line = 0;  ///< number in the file
  std::string found, expected;
  /// Lines may have been dropped there, which is allowed under the real clock: the process's end decides.
  bool may_be_dropped = false;
};

/// The collector of a rule's findings.
class Findings {
 public:
  Findings(const Rule& rule, std::size_t line, std::vector<Violation>& violations)
      : rule_(rule), line_(line), violations_(violations) {}

  void add(std::string found, std::string expected) {
    violations_.push_back({&rule_, line_, std::move(found), std::move(expected), false});
  }
  /// Adds a finding that missing steps would explain.
  void add_unless_dropped(std::string found, std::string expected) {
    violations_.push_back({&rule_, line_, std::move(found), std::move(expected), true});
  }

 private:
  const Rule& rule_;
  std::size_t line_;
  std::vector<Violation>& violations_;
};

/// One step and the record of the steps before it.
struct Step {
  const Line& line;
  const Line* before;                    ///< of the step before; null at the first one, or where steps are missing
  const InstructionMemory* instruction;  ///< null when the instruction begins with this step
  const ProcessMemory* process;          ///< null at the process's first step
  const Memory& memory;

  bool simulated() const noexcept { return memory.simulated; }
  bool begins() const noexcept { return instruction == nullptr; }
};

/// One law that every trace satisfies. Rules are independent of each other and have no state.
struct Rule {
  const char* name;
  const char* equation;  ///< the equation of the paper, or the part of the design, that it states
  const char* says;
  /// Checks a step. Null: the rule is about ends.
  void (*check)(const Step& step, Findings& findings);
  /// Checks a process's end. Null: the rule is about steps.
  void (*check_end)(const ProcessEnd& end, const Memory& memory, Findings& findings) = nullptr;
};

using Rules = std::vector<Rule>;

/// All of them, in the order in which they are listed and checked.
Rules all_rules();

// the parts of the list
Rules rules_of_lines();
Rules rules_of_instructions();
Rules rules_of_endings();
Rules rules_of_commands();
Rules rules_of_answers();
Rules rules_of_sensors();
Rules rules_of_coordination();

}  // namespace mrroc::cli::trace
