// Checks that e^{i+1} answers the command of step i in time: a macrostep of N ticks whose state is that of tick v.
#include <algorithm>

#include "cli/trace/answer.hpp"
#include "cli/trace/words.hpp"

namespace mrroc::cli::trace {

namespace {

/// The process had nothing else to wait for between the newest tick of the step and its commands.
bool sent_at_once(const Step& step) {
  if (step.memory.black_box) return false;  // it may have an instruction in progress without a step so far
  const std::vector<SensorEntry>& sensors = step.before->sensors;
  return step.process->open.size() == 1 && std::all_of(sensors.begin(), sensors.end(), [](const SensorEntry& sensor) {
           return sensor.mode == SensorMode::published;
         });
}

void macrostep_start(const Step& step, Findings& findings) {
  for (const Answer& answer : answers(step)) {
    const Tick start = answer.to.macrostep;
    const Tick earliest = std::max(answer.command.start_tick, answer.end_before);
    const std::string found = words("macrostep=", start, " of robot ", answer.to.name);
    if (start < earliest) findings.add(found, words("at least ", earliest));
    if (start <= earliest || answer.late || answer.after_force || answer.by_ecp) continue;
    // a moving robot cannot begin later, because it would have braked; a held robot may
    if (answer.from.moving && answer.command.kind != CommandKind::hold && earliest == answer.end_before)
      findings.add(found, words(earliest, ", where the motion before ends"));
    const Tick sent = step.before->tick;
    const bool stops_first = answer.from.moving && answer.command.start_tick > answer.end_before;
    if (step.simulated() && !stops_first && (sent_at_once(step) || answer.command.start_tick > sent) &&
        start != std::max(earliest, sent))
      findings.add(found, words(std::max(earliest, sent)));
  }
}

void reply_tick(const Step& step, Findings& findings) {
  for (const Answer& answer : answers(step)) {
    const CommandEntry& command = answer.command;
    const std::string found = words("tick=", answer.to.tick, " of robot ", answer.to.name);
    if (command.motion_steps < 1 || command.motion_steps > kMaxMotionSteps || command.reply_step < 1 ||
        command.reply_step > command.motion_steps + 1) {
      findings.add(words("an answer to N=", command.motion_steps, ", v=", command.reply_step), "an error");
      continue;
    }
    const Tick due = answer.to.macrostep + command.reply_step;
    const bool after = command.reply_step > command.motion_steps;  // regardless of the length of the macrostep
    if (answer.to.tick < due) findings.add(found, words(due, ", tick ", command.reply_step, " of the macrostep"));
    if (answer.to.tick > due && step.simulated() && !after)
      findings.add(found, words(due, ", tick ", command.reply_step, " of the macrostep"));
  }
}

void macrostep_end(const Step& step, Findings& findings) {
  for (const RobotEntry& robot : step.line.robots)
    if (robot.desired_tick < robot.tick)
      findings.add(words("desired_tick=", robot.desired_tick, " of robot ", robot.name),
                   words("at least ", robot.tick));
  for (const Answer& answer : answers(step)) {
    const CommandEntry& command = answer.command;
    const Tick end = answer.to.macrostep + command.motion_steps;
    const std::string found = words("desired_tick=", answer.to.desired_tick, " of robot ", answer.to.name);
    if (answer.to.tick > end) {  // the state is from after the end: at rest, or in a stop
      if (answer.to.moving)
        findings.add(words("robot ", answer.to.name, " moves after its macrostep"), "rest, or a stop");
      continue;
    }
    if (answer.by_ecp || answer.joined) continue;
    if (command.kind == CommandKind::force) {
      if (answer.to.desired_tick != answer.to.tick && answer.to.tick < end)
        findings.add(found, words(answer.to.tick, ", the set-point of now: where a force motion leads is not known"));
      continue;
    }
    if (answer.to.desired_tick < end) findings.add(found, words("at least ", end, ", N after the macrostep's start"));
    if (answer.to.desired_tick > end && !answer.late && !answer.after_force)
      findings.add(found, words(end, ", N after the macrostep's start"));
  }
}

void rest_before_resume(const Step& step, Findings& findings) {
  const Line& line = step.line;
  if (step.before == nullptr || line.ends()) return;
  bool late = false;
  for (std::size_t i = 0; i < std::min(line.robots.size(), step.before->robots.size()); ++i)
    if (!step.before->robots[i].superior)  // the MP decides
      late = late || line.robots[i].late > step.before->robots[i].late;
  const bool paused = line.held != 0 && line.is_move;  // a Wait continues holding: it needs no rest
  if (!paused && !late) return;
  for (const RobotEntry& robot : line.robots)
    if (robot.moving)
      findings.add(words("robot ", robot.name, " still moves"),
                   words("rest before the motion continues after a ", late ? "late command" : "pause"));
}

/// Every hold takes at least a tick, after the macrostep of the command before it.
void held_steps(const Step& step, Findings& findings) {
  const Line& line = step.line;
  if (line.held == 0) return;
  if (step.begins() && line.robots.empty()) return;
  if (step.before == nullptr || line.broken_off() || line.robots.size() != step.before->robots.size()) return;
  for (std::size_t i = 0; i < line.robots.size(); ++i) {
    const RobotEntry& from = step.before->robots[i];
    const RobotEntry& to = line.robots[i];
    if (!from.command || to.error != ErrorClass::none) continue;
    const Tick end = std::max(from.command->start_tick, from.desired_tick) + from.command->motion_steps;
    // not executed, or in part, because its group brakes
    const bool cut_short = has_left(from, to) || has_another_stopped(step, i);
    const Tick earliest = (cut_short ? from.desired_tick : end) + line.held - 1;
    if (to.macrostep < earliest)
      findings.add(words("macrostep=", to.macrostep, " of robot ", from.name, " after ", line.held, " holds"),
                   words("at least ", earliest));
  }
}

}  // namespace

Rules rules_of_answers() {
  return {{"macrostep-start", "(3) (5): from e(i) to e(i+1)",
           "a macrostep begins where the one before ends, not before its start tick, and at once", macrostep_start},
          {"reply-tick", "(3) (5): e(i+1)", "the state is that of tick v of the macrostep", reply_tick},
          {"macrostep-end", "(3) (5): e(i+1)", "the desired state is that of tick N of the macrostep", macrostep_end},
          {"rest-before-resume", "(5): f_e* from rest", "after a pause or a late command the robots have come to rest",
           rest_before_resume},
          {"held-steps", "(5)", "macrosteps of hold come after the command's own", held_steps}};
}

}  // namespace mrroc::cli::trace
