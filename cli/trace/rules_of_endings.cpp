// The cases of equations (3) and (5): an instruction continues with a command, or ends by f_I or f_T, by f_E, or on
// request.
#include "cli/trace/condition_value.hpp"
#include "cli/trace/rule.hpp"
#include "cli/trace/words.hpp"

namespace mrroc::cli::trace {

namespace {

std::string condition_name(const Line& line) { return line.is_move ? line.until.value_or("") : line.name; }

void end_or_command(const Step& step, Findings& findings) {
  for (const RobotEntry& robot : step.line.robots) {
    if (step.line.ends() && robot.command) findings.add(words("a command to ", robot.name), "none: it ends here");
    if (!step.line.ends() && !robot.command) findings.add(words("no command to ", robot.name), "one, or end=");
  }
}

void condition_decides(const Step& step, Findings& findings) {
  const Line& line = step.line;
  const PossibleValues value =
      line.conditions.empty() ? PossibleValues{true, false} : value_of_condition(condition_name(line), line.conditions);
  const std::string parts = words("\"", condition_name(line), "\" with ", text_of_values(line.conditions));
  if (line.ending == StepEnding::condition) {
    if (value.is_false()) findings.add(words("end=condition, ", parts), "an end when it holds");
    if (step.instruction != nullptr && step.instruction->goes_on_with.contains(key_of(line.conditions)))
      findings.add(words("end=condition, ", parts), "no end: it continued with the same values before");
  } else if (value.is_true()) {
    findings.add(words("it ", line.ends() ? "does not end by its condition" : "continues", ", ", parts),
                 "end=condition");
  }
}

void wait_ends_by_condition(const Step& step, Findings& findings) {
  if (!step.line.is_move && step.line.ending == StepEnding::generator)
    findings.add("end=generator of a Wait", "end=condition: it has no generator");
}

StepEnding ending_of(ErrorClass error) {
  if (error == ErrorClass::non_fatal) return StepEnding::non_fatal_error;
  return error == ErrorClass::hardware ? StepEnding::hardware_error : StepEnding::system_error;
}

void error_decides(const Step& step, Findings& findings) {
  ErrorClass most_severe = ErrorClass::none;
  std::string device;
  const auto check = [&](ErrorClass error, const std::string& name) {
    if (error <= most_severe) return;
    most_severe = error;
    device = name;
  };
  for (const RobotEntry& robot : step.line.robots) check(robot.error, robot.name);
  for (const SensorEntry& sensor : step.line.sensors) check(sensor.error, sensor.name);
  // an instruction that is broken off ends by an unexpected event
  if (most_severe != ErrorClass::none && !step.line.broken_off() && step.line.ending != ending_of(most_severe))
    findings.add(words("an error of ", device, ", and the instruction does not end by it"),
                 "end= with the class of the most severe error");
}

void skew(const Step& step, Findings& findings) {
  const Line& line = step.line;
  const bool shown = line.ends() && line.robots.size() > 1;
  if (line.skew.has_value() != shown) {
    findings.add(line.skew ? "skew=" : "no skew=", shown ? "one: several robots end here" : "none");
    return;
  }
  if (!shown || line.broken_off() || (step.before == nullptr && !step.begins())) return;
  // the skew of a step followed by a hold was measured on states that are not in the trace
  const bool seen = step.before != nullptr && line.held == 0;
  const Tick known = std::max(step.instruction == nullptr ? 0 : step.instruction->skew, seen ? spread(line) : 0);
  const bool all_known = (step.instruction == nullptr || step.instruction->skew_is_known) &&
                         (step.begins() ? !step.memory.began_before(line) : seen);
  if (*line.skew < known || (all_known && *line.skew != known))
    findings.add(words("skew=", *line.skew),
                 words(all_known ? "" : "at least ", known, ", the worst of its macrosteps"));
}

}  // namespace

Rules rules_of_endings() {
  return {{"end-or-command", "(3) (5)", "every robot is commanded at a step, none at the end", end_or_command},
          {"condition-decides", "(3) f_I, (5) f_T", "it ends by its condition when that holds, and only then",
           condition_decides},
          {"wait-has-no-generator", "(3) f_I", "a Wait does not end by a generator", wait_ends_by_condition},
          {"error-decides", "(3) (5) f_E", "it ends by the most severe error that a robot or sensor reports",
           error_decides},
          {"skew", "coordination", "skew= is the worst spread of the robots' macrosteps", skew}};
}

}  // namespace mrroc::cli::trace
