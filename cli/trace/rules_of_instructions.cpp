// Instructions of a process and their steps: i = i0, i0 + 1, ..., im.
#include <algorithm>

#include "cli/trace/rule.hpp"
#include "cli/trace/words.hpp"

namespace mrroc::cli::trace {

namespace {

std::uint64_t last_instruction(const Step& step) {
  return step.process == nullptr ? 0 : step.process->last_instruction;
}

void instruction_count(const Step& step, Findings& findings) {
  const std::uint64_t last = last_instruction(step);
  if (step.memory.black_box) return;  // instructions between may have ended before it begins
  if (!step.begins() || step.line.instruction == last + 1) return;
  if (step.line.instruction <= last) return;  // nothing-after-end reports it
  findings.add_unless_dropped(words("instruction ", step.line.instruction), words("instruction ", last + 1));
}

void step_count(const Step& step, Findings& findings) {
  if (step.begins()) {
    if (step.line.step != 0 && step.line.instruction > last_instruction(step) && !step.memory.began_before(step.line))
      findings.add_unless_dropped(words("it begins with step ", step.line.step), "step 0");
    return;
  }
  const Line& before = step.instruction->before;
  const bool same = step.line.step == before.step && step.line.broken_off();
  if (step.line.step == before.step + 1 || same) return;
  // steps that are missing leave a gap; a repeated step is always a violation
  const std::string found = words("step ", step.line.step), expected = words("step ", before.step + 1);
  if (step.line.step > before.step)
    findings.add_unless_dropped(found, expected);
  else
    findings.add(found, expected);
}

template <class Entry>
std::string names_of(const std::vector<Entry>& entries) {
  std::string text;
  for (const Entry& entry : entries) text.append(text.empty() ? "" : ", ").append(entry.name);
  return text.empty() ? "none" : text;
}

std::string form_of(const Line& line) {
  std::string text = words(line.is_move ? "move=\"" : "wait=\"", line.name, "\"");
  if (line.until) text += words(" until=\"", *line.until, "\"");
  text += words(", robots ", names_of(line.robots), ", sensors ", names_of(line.sensors));
  for (const RobotEntry& robot : line.robots) text += words(", ", robot.joints.size(), " joints");
  for (const SensorEntry& sensor : line.sensors) text += words(", period ", sensor.period);
  for (const SensorEntry& sensor : line.sensors)
    if (sensor.mode != SensorMode::interactive) text += sensor.mode == SensorMode::polled ? ", polled" : ", published";
  return text;
}

template <class Entry, class Same>
bool all_same(const std::vector<Entry>& a, const std::vector<Entry>& b, Same same) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool same_form(const Line& a, const Line& b) {
  return a.is_move == b.is_move && a.name == b.name && a.until == b.until &&
         all_same(a.robots, b.robots,
                  [](const RobotEntry& x, const RobotEntry& y) {
                    return x.name == y.name && x.joints.size() == y.joints.size();
                  }) &&
         all_same(a.sensors, b.sensors, [](const SensorEntry& x, const SensorEntry& y) {
           return x.name == y.name && x.period == y.period && x.mode == y.mode;
         });
}

bool same_names(const std::vector<ConditionEntry>& a, const std::vector<ConditionEntry>& b) {
  return all_same(a, b, [](const ConditionEntry& x, const ConditionEntry& y) { return x.name == y.name; });
}

/// The parts of the condition are not in the step of an end that does not evaluate them.
bool shows_conditions(const Line& line) {
  return !line.ends() || line.ending == StepEnding::condition || line.ending == StepEnding::generator;
}

void one_form(const Step& step, Findings& findings) {
  const Line& line = step.line;
  if (step.instruction != nullptr && !step.instruction->interrupted) {
    const Line& before = step.instruction->before;
    if (!same_form(line, before)) findings.add(form_of(line), form_of(before));
    if (shows_conditions(line) && !same_names(line.conditions, before.conditions))
      findings.add(words("conditions ", names_of(line.conditions)), names_of(before.conditions));
  }
  const bool has_condition = !line.is_move || line.until;
  if (shows_conditions(line) && line.conditions.empty() == has_condition)
    findings.add(line.conditions.empty() ? "no condition" : "conditions",
                 line.conditions.empty() ? "the parts of the condition" : "none: the Move has no until=");
  if (!shows_conditions(line) && !line.conditions.empty())
    findings.add("values of conditions", "none: they are not evaluated at this end");
}

template <class Entry>
void find_twice(const std::vector<Entry>& entries, const char* what, Findings& findings) {
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (entries[i].name == entries[k].name) findings.add(words(what, entries[i].name, " twice"), "once");
}

void lists(const Step& step, Findings& findings) {
  find_twice(step.line.robots, "robot ", findings);
  find_twice(step.line.sensors, "sensor ", findings);
  if (step.process == nullptr) return;
  for (const auto& [number, other] : step.process->open) {
    if (number == step.line.instruction) continue;
    for (const RobotEntry& robot : step.line.robots)
      for (const RobotEntry& taken : other.before.robots)
        if (robot.name == taken.name)
          findings.add_unless_dropped(words("robot ", robot.name, " while instruction ", number, " of message ",
                                            other.before.number, " moves it"),
                                      words("the end of instruction ", number, " before"));
  }
}

void nothing_after_end(const Step& step, Findings& findings) {
  if (step.begins() && step.line.instruction <= last_instruction(step) && !step.memory.began_before(step.line))
    findings.add(words("a step of instruction ", step.line.instruction), "none: it has ended before");
}

void all_end(const ProcessEnd& end, const Memory& memory, Findings& findings) {
  const ProcessMemory* process = memory.process(end.process);
  if (process == nullptr) return;
  if (process->ended) findings.add(words("a second end of process ", end.process), "one");
  if (memory.black_box) return;  // other instructions continue in parallel when an error ends one
  for (const auto& [number, open] : process->open)
    findings.add_unless_dropped(
        words("instruction ", number, " stops at message ", open.before.number, " without an end"),
        "an end: the process was not killed");
}

void nothing_after_remark(const Step& step, Findings& findings) {
  if (step.process != nullptr && step.process->ended)
    findings.add(words("a step of process ", step.line.process), "none behind its end");
}

}  // namespace

Rules rules_of_instructions() {
  return {{"instruction-count", "(3) (5)", "a process's instructions are 1, 2, 3, ...", instruction_count},
          {"step-count", "(3) (5): i = i0, ..., im", "an instruction's steps are 0, 1, 2, ...", step_count},
          {"one-form", "(3) (5)", "an instruction's steps have one name, one condition, one list of robots and sensors",
           one_form},
          {"lists", "(3) (5)", "a robot or sensor is once in a step, a robot in one instruction at a time", lists},
          {"nothing-after-end", "(3) (5): i <= im", "nothing follows an instruction's end", nothing_after_end},
          {"all-end", "(3) (5): im", "every instruction of a process that was not killed ends", nullptr, all_end},
          {"end-is-last", "trace", "nothing of a process follows its end", nothing_after_remark}};
}

}  // namespace mrroc::cli::trace
