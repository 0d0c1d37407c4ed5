// The file itself: its steps and their order.
#include <algorithm>
#include <tuple>

#include "cli/trace/rule.hpp"
#include "cli/trace/words.hpp"

namespace mrroc::cli::trace {

namespace {

/// Under the real clock the recording does not wait for a step that comes late.
void line_order(const Step& step, Findings& findings) {
  const auto& [line, memory] = std::tie(step.line, step.memory);
  if (!memory.simulated || std::tie(line.made, line.process) >= std::tie(memory.last_made, memory.last_process)) return;
  findings.add(words("tick ", line.made, " of process ", line.process),
               words("a step not before tick ", memory.last_made, " of process ", memory.last_process));
}

void line_tick(const Step& step, Findings& findings) {
  Tick newest = 0;
  for (const RobotEntry& robot : step.line.robots) newest = std::max(newest, robot.tick);
  for (const SensorEntry& sensor : step.line.sensors) newest = std::max(newest, sensor.tick);
  if (step.line.tick != newest) findings.add(words("tick=", step.line.tick), words(newest, ", the newest in the step"));
}

/// Ticks and counts of the robots of one process never decrease.
void ticks_go_on(const Step& step, Findings& findings) {
  if (step.process == nullptr) return;
  for (const RobotEntry& robot : step.line.robots) {
    const auto known = step.process->robots.find(robot.name);
    if (known == step.process->robots.end()) continue;
    if (robot.tick < known->second.tick)
      findings.add(words("tick ", robot.tick, " of robot ", robot.name), words("at least ", known->second.tick));
    if (robot.late < known->second.late)
      findings.add(words(robot.late, " late commands of robot ", robot.name), words("at least ", known->second.late));
    if (robot.macrostep < known->second.macrostep)
      findings.add(words("macrostep ", robot.macrostep, " of robot ", robot.name),
                   words("at least ", known->second.macrostep));
  }
}

/// The instruction's previous reading of this sensor; at its first step, the process's.
const SensorEntry* reading_before(const Step& step, const std::string& sensor) {
  if (step.instruction != nullptr) {
    for (const SensorEntry& entry : step.instruction->before.sensors)
      if (entry.name == sensor) return &entry;
    return nullptr;
  }
  if (step.process == nullptr) return nullptr;
  const auto known = step.process->sensors.find(sensor);
  return known == step.process->sensors.end() ? nullptr : &known->second;
}

/// Per instruction: one of two parallel instructions may hold an older reading, which is not yet due again.
void readings_go_on(const Step& step, Findings& findings) {
  for (const SensorEntry& sensor : step.line.sensors) {
    const SensorEntry* before = reading_before(step, sensor.name);
    if (before != nullptr && sensor.tick < before->tick && !sensor.emptied_since(*before))
      findings.add(words("tick ", sensor.tick, " of sensor ", sensor.name), words("at least ", before->tick));
  }
}

void every_line(const ProcessEnd& end, const Memory& memory, Findings& findings) {
  const ProcessMemory* process = memory.process(end.process);
  const std::uint64_t lines = process == nullptr ? 0 : process->lines;
  if (lines != end.lines)
    findings.add(words(lines, " steps of process ", end.process), words(end.lines, ", as many as it has passed on"));
  if (memory.simulated && end.dropped != 0)
    findings.add(words(end.dropped, " dropped steps"), "none: a simulated clock waits for the recording");
}

}  // namespace

Rules rules_of_lines() {
  return {{"step-order", "trace", "steps are in the order in which they were made, by tick, then process", line_order},
          {"step-tick", "trace", "tick is the newest one of the step's robots and sensors", line_tick},
          {"ticks-go-on", "trace", "ticks and late counts of a process's robots never decrease", ticks_go_on},
          {"readings-go-on", "trace", "no reading is older than the instruction's one before", readings_go_on},
          {"every-step", "trace", "every step that a process has passed on is there", nullptr, every_line}};
}

}  // namespace mrroc::cli::trace
