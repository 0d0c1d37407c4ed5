#include "cli/trace/answer.hpp"

namespace mrroc::cli::trace {

namespace {

/// In an ECP's Move with its MP, which has another robot: it holds when that one has stopped alone.
bool is_held_by_the_mp(const RobotEntry& robot) { return robot.superior && robot.superior->kind == CommandKind::hold; }

}  // namespace

bool has_left(const RobotEntry& from, const RobotEntry& to) {
  return from.coordination == Coordination::takes_part && to.coordination != Coordination::takes_part;
}

bool has_another_stopped(const Step& step, std::size_t self) {
  for (std::size_t i = 0; i < step.line.robots.size(); ++i) {
    const RobotEntry& from = step.before->robots[i];
    const RobotEntry& to = step.line.robots[i];
    if (i == self) continue;
    if (to.error != ErrorClass::none || to.late > from.late || has_left(from, to)) return true;
  }
  return false;
}

std::vector<Answer> answers(const Step& step) {
  std::vector<Answer> found;
  const Line& line = step.line;
  if (step.before == nullptr || line.held != 0 || line.obtained || line.broken_off() ||
      line.robots.size() != step.before->robots.size())
    return found;
  for (std::size_t i = 0; i < line.robots.size(); ++i) {
    const RobotEntry& from = step.before->robots[i];
    const RobotEntry& to = line.robots[i];
    const bool moves =
        from.command && from.command->kind != CommandKind::query && from.command->kind != CommandKind::set_tool;
    if (to.coordination == Coordination::left) continue;  // the command was not executed
    if (!moves || to.error != ErrorClass::none || from.name != to.name) continue;
    Answer answer{from, *from.command, to};
    const RobotMemory* known = step.memory.robot(from.name);
    // at the first state of a black box, the end of the motion before it is unknown
    if (step.before->step != 0 && (known == nullptr || !known->answered)) continue;
    const bool forced = known != nullptr && known->forced;
    // at the first step the state answers a query and gives the end of every accepted motion
    answer.end_before = forced && step.before->step != 0 ? from.macrostep + known->steps : from.desired_tick;
    answer.after_force = forced && from.command->kind != CommandKind::force;
    answer.late = to.late > from.late;
    answer.in_group = line.robots.size() > 1 || from.superior || to.superior;
    answer.joined = !to.moving && (has_another_stopped(step, i) || is_held_by_the_mp(to));
    answer.by_ecp = to.coordination == Coordination::takes_part;
    found.push_back(answer);
  }
  return found;
}

}  // namespace mrroc::cli::trace
