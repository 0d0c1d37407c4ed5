#include <algorithm>

#include "cli/trace/mutations.hpp"

namespace mrroc::cli::trace {

namespace {

using RobotChange = std::function<void(Line&, RobotEntry&, Random&)>;
using RobotSuits = std::function<bool(const TraceSteps&, std::size_t, std::size_t)>;

Mutation of_robot(const char* name, RobotSuits suits, RobotChange change) {
  return {name, [suits, change](TraceSteps& trace, Random& random) {
            const auto place = pick_robot(
                trace, random, [&](std::size_t line, std::size_t robot) { return suits(trace, line, robot); });
            if (place) change(trace.line(place->line), trace.line(place->line).robots[place->robot], random);
            return place.has_value();
          }};
}

/// The state of the robot in line i answers the command of the line before.
bool answers_in(const TraceSteps& trace, std::size_t i, std::size_t k) {
  const std::size_t before = line_before(trace, i);
  const Line& line = trace.line(i);
  return before != kNoLine && line.held == 0 && line.robots[k].coordination == Coordination::none &&
         !line.broken_off() && line.robots[k].error == ErrorClass::none &&
         trace.line(before).robots[k].command.has_value();
}

/// The command of the robot in line i is answered by the line behind.
bool is_answered(const TraceSteps& trace, std::size_t i, std::size_t k) {
  const std::size_t behind = line_behind(trace, i);
  return trace.line(i).robots[k].command.has_value() && behind != kNoLine && answers_in(trace, behind, k);
}

CommandKind answered_kind(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return trace.line(line_before(trace, i)).robots[k].command->kind;
}

bool commanded_kind(const TraceSteps& trace, std::size_t i, std::size_t k, CommandKind kind) {
  return is_answered(trace, i, k) && trace.line(i).robots[k].command->kind == kind;
}

/// The reply leaves within the macrostep. Afterwards the macrostep has its final length.
bool replies_within(const CommandEntry& command) { return command.reply_step <= command.motion_steps; }

bool answers_within(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return answers_in(trace, i, k) && replies_within(*trace.line(line_before(trace, i)).robots[k].command);
}

/// Where the desired position was commanded. Elsewhere it is the position before the instruction, or results from a
/// stop, a velocity, a force or the joints of a pose: the trace does not contain it.
bool desired_is_commanded(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return answers_in(trace, i, k) && answered_kind(trace, i, k) == CommandKind::joint;
}

bool pose_is_commanded(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return answers_in(trace, i, k) && answered_kind(trace, i, k) == CommandKind::pose;
}

bool follows_force(const TraceSteps& trace, std::size_t i, std::size_t k) {
  for (std::size_t at = i; at-- > 0;) {
    if (!trace.is_line(at)) continue;
    for (const RobotEntry& robot : trace.line(at).robots)
      if (robot.name == trace.line(i).robots[k].name && robot.command) return robot.command->kind == CommandKind::force;
  }
  return false;
}

/// The trace contains neither the path of a force motion nor the duration of the stop behind it.
bool answers_no_force(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return answers_within(trace, i, k) && answered_kind(trace, i, k) != CommandKind::force &&
         !follows_force(trace, line_before(trace, i), k);
}

/// A hold of a robot at rest, which then stays there.
bool holds_at_rest(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return commanded_kind(trace, i, k, CommandKind::hold) && !trace.line(i).robots[k].moving &&
         !follows_force(trace, i, k);
}

double some(Random& random) { return 0.001 * static_cast<double>(pick(random, 1, 100)); }

void change_kind(Line&, RobotEntry& robot, Random&) {
  robot.command->kind = CommandKind::joint;
  robot.command->target.assign(robot.desired.size(), 0.125);
}

bool has_common_start(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return trace.line(i).robots.size() > 1 && is_answered(trace, i, k);
}

/// Not where it is the last value of its process about the robot: no later count contradicts it.
bool is_told_again(const TraceSteps& trace, std::size_t i, std::size_t /*k*/) {
  return line_behind(trace, i) != kNoLine;
}

bool commanded(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return trace.line(i).robots[k].command.has_value();
}

bool steps_count(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return is_answered(trace, i, k) && answers_no_force(trace, line_behind(trace, i), k);
}

/// A target that the next step must desire.
bool target_counts(const TraceSteps& trace, std::size_t i, std::size_t k) {
  return commanded_kind(trace, i, k, CommandKind::joint) || commanded_kind(trace, i, k, CommandKind::pose);
}

/// Not an increment on the desired position of the line: the robot has not stopped first.
bool increment_counts(const TraceSteps& trace, std::size_t i, std::size_t k) {
  if (!target_counts(trace, i, k) || follows_force(trace, i, k)) return false;
  return !trace.line(i).robots[k].moving ||
         trace.line(line_behind(trace, i)).robots[k].macrostep == trace.line(i).robots[k].desired_tick;
}

}  // namespace

std::vector<Mutation> mutations_of_robots() {
  return {
      of_robot("a later state", answers_within,
               [](Line& line, RobotEntry& robot, Random& random) {
                 robot.tick += pick(random, 1, 20);
                 line.tick = std::max(line.tick, robot.tick);
               }),
      of_robot("an earlier state", answers_in,
               [](Line&, RobotEntry& robot, Random& random) {
                 robot.tick -= pick(random, 1, std::min<Tick>(5, robot.tick));
               }),
      of_robot("a macrostep that begins elsewhere", answers_in,
               [](Line&, RobotEntry& robot, Random& random) { robot.macrostep += pick(random, 1, 9); }),
      of_robot("a longer macrostep", answers_no_force,
               [](Line&, RobotEntry& robot, Random& random) { robot.desired_tick += pick(random, 1, 20); }),
      of_robot("a shorter macrostep", answers_no_force,
               [](Line&, RobotEntry& robot, Random& random) {
                 robot.desired_tick -= pick(random, 1, std::min<Tick>(20, robot.desired_tick));
               }),
      of_robot("other desired joints", desired_is_commanded,
               [](Line&, RobotEntry& robot, Random& random) {
                 robot.desired[pick(random, 0, robot.desired.size() - 1)] += some(random);
               }),
      of_robot(
          "another desired pose", pose_is_commanded,
          [](Line&, RobotEntry& robot, Random& random) { robot.desired_pose[pick(random, 0, 2)] += some(random); }),
      of_robot("a robot that drifts while it holds", holds_at_rest,
               [](Line&, RobotEntry& robot, Random& random) { robot.desired.front() += some(random); }),
      of_robot("a motion during a hold", holds_at_rest, change_kind),
      of_robot("another target", target_counts,
               [](Line&, RobotEntry& robot, Random& random) { robot.command->target.front() += some(random); }),
      of_robot("a relative command", increment_counts,
               [](Line&, RobotEntry& robot, Random&) { robot.command->relative = !robot.command->relative; }),
      of_robot(
          "another command of the MP than its ECP saw",
          [](const TraceSteps& trace, std::size_t i, std::size_t k) {
            return trace.line(i).robots[k].superior.has_value();
          },
          [](Line&, RobotEntry& robot, Random& random) { robot.superior->target.front() += some(random); }),
      of_robot("another N", steps_count,
               [](Line&, RobotEntry& robot, Random& random) { robot.command->motion_steps += pick(random, 1, 20); }),
      of_robot("another v", is_answered,
               [](Line&, RobotEntry& robot, Random& random) { robot.command->reply_step += pick(random, 1, 2); }),
      of_robot("a later start tick", has_common_start,
               [](Line&, RobotEntry& robot, Random& random) { robot.command->start_tick += pick(random, 1, 20); }),
      of_robot("no start tick", has_common_start,
               [](Line&, RobotEntry& robot, Random&) { robot.command->start_tick = 0; }),
      of_robot("no command", commanded, [](Line&, RobotEntry& robot, Random&) { robot.command.reset(); }),
      of_robot(
          "a command at the end",
          [](const TraceSteps& trace, std::size_t i, std::size_t) { return trace.line(i).ends(); },
          [](Line&, RobotEntry& robot, Random&) { robot.command = CommandEntry{}; }),
      of_robot("a late command", is_told_again, [](Line&, RobotEntry& robot, Random&) { ++robot.late; }),
      of_robot("a hold that was not", answers_in,
               [](Line& line, RobotEntry&, Random& random) { line.held += pick(random, 1, 3); }),
      of_robot("another robot", is_told_again, [](Line&, RobotEntry& robot, Random&) { robot.name += "2"; }),
      of_robot("one joint less", is_told_again,
               [](Line&, RobotEntry& robot, Random&) {
                 robot.joints.pop_back();
                 robot.desired.pop_back();
               }),
      of_robot("an error that does not end it", commanded,
               [](Line&, RobotEntry& robot, Random&) {
                 robot.error = ErrorClass::hardware;
                 robot.error_code = "a drive reports a fault";
               }),
  };
}

}  // namespace mrroc::cli::trace
