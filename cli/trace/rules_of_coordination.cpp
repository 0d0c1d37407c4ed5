// Several robots in one instruction, several processes with one robot.
#include <algorithm>

#include "cli/trace/answer.hpp"
#include "cli/trace/words.hpp"

namespace mrroc::cli::trace {

namespace {

void common_start(const Step& step, Findings& findings) {
  if (step.line.robots.size() < 2) return;
  for (const RobotEntry& robot : step.line.robots) {
    if (!robot.command) continue;
    if (robot.command->start_tick == 0)
      findings.add(words("no start tick for ", robot.name), "one: several robots are commanded together");
  }
}

/// Checks that robots with one start tick begin on it.
void no_skew(const Step& step, Findings& findings) {
  if (!step.simulated() || step.line.robots.size() < 2) return;
  const std::vector<Answer> found = answers(step);
  if (found.size() != step.line.robots.size()) return;
  const auto another = [&](const Answer& answer) {
    return answer.command.start_tick != found.front().command.start_tick || answer.late || answer.after_force;
  };
  if (std::none_of(found.begin(), found.end(), another) && spread(step.line) != 0)
    findings.add(words("macrosteps that begin up to ", spread(step.line), " ticks apart"), "one tick for all");
}

/// The MP and the ECP of the robot command it in the step before: equation (11). The ECP may join between the query
/// and the first command of a Move, and leave before the next one: it takes part if it has answered either.
bool take_part(const Step& step, const RobotEntry& before, const std::string& other) {
  if (step.line.process == before.name) return before.superior.has_value();
  const auto answered_by_ecp = [&before](const RobotEntry& robot) {
    return robot.name == before.name && robot.coordination != Coordination::none;
  };
  return other == before.name &&
         (answered_by_ecp(before) || std::any_of(step.line.robots.begin(), step.line.robots.end(), answered_by_ecp));
}

void one_commander(const Step& step, Findings& findings) {
  if (step.before == nullptr) return;
  for (const RobotEntry& robot : step.before->robots) {
    const RobotMemory* known = step.memory.robot(robot.name);
    if (!robot.command || known == nullptr) continue;
    for (const auto& [process, command] : known->by) {
      if (process == step.line.process || take_part(step, robot, process) || command.tick < step.before->tick ||
          command.tick >= step.line.tick)
        continue;
      findings.add(words("robot ", robot.name, " is commanded by ", process, " too, at tick ", command.tick,
                         " in message ", command.line),
                   words("by ", step.line.process, " alone, from tick ", step.before->tick, " to ", step.line.tick));
    }
  }
}

/// The steps of the MP and of the ECP about one step may come in either order: the later one is compared.
void superior_command(const Step& step, Findings& findings) {
  if (step.memory.black_box) return;  // steps of one side may be missing
  for (const RobotEntry& robot : step.line.robots) {
    if (robot.superior && !robot.command)
      findings.add(words("superior command of robot ", robot.name, " without a command"),
                   "the command that follows from it");
    const RobotMemory* known = step.memory.robot(robot.name);
    const CommandEntry* other = known != nullptr ? known->wish_of(step.line, robot) : nullptr;
    if (other != nullptr && *other != (robot.superior ? *robot.superior : *robot.command))
      findings.add_unless_dropped(
          words("the command of the MP to robot ", robot.name, " differs from the superior command in the step"),
          "one command in the steps of the MP and of the ECP");
  }
}

}  // namespace

Rules rules_of_coordination() {
  return {
      {"common-start", "coordination", "robots that are commanded together are given a start tick", common_start},
      {"no-skew", "coordination", "robots with one start tick begin on it (simulated clocks)", no_skew},
      {"superior-command", "(11): c_0", "an ECP that takes part sees the command that the MP sends", superior_command},
      {"one-commander", "coordination", "no two processes command a robot at the same time", one_commander}};
}

}  // namespace mrroc::cli::trace
