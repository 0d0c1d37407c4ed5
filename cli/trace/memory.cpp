#include "cli/trace/memory.hpp"

#include <algorithm>

namespace mrroc::cli::trace {

namespace {

constexpr std::size_t kValuesKept = 4096;  // of one instruction's conditions

template <class Map>
auto find_in(const Map& map, const typename Map::key_type& key) -> const typename Map::mapped_type* {
  const auto found = map.find(key);
  return found == map.end() ? nullptr : &found->second;
}

bool follows(const Line& line, const Line& before) {
  return line.step == before.step + 1 || (line.step == before.step && line.broken_off());
}

/// The later one of the two steps about a step is compared with the earlier one, and then both are settled. Holds of
/// the MP have a step of the ECP only.
void remember_superior(const Line& line, const RobotEntry& robot, RobotMemory& known) {
  if (robot.coordination == Coordination::left) known.followed.reset();
  if (robot.superior) {
    if (known.wish_of(line, robot) != nullptr)
      known.wished.reset();
    else
      known.followed = {robot.tick, *robot.superior};
  } else if (robot.command && line.process != robot.name) {
    if (known.wish_of(line, robot) != nullptr)
      known.followed.reset();
    else
      known.wished = {robot.tick, *robot.command};
  }
}

void remember_robots(const Line& line, const Line* before, Memory& memory, ProcessMemory& process) {
  for (std::size_t i = 0; i < line.robots.size(); ++i) {
    const RobotEntry& robot = line.robots[i];
    process.robots[robot.name] = robot;
    process.robots[robot.name].command.reset();
    RobotMemory& known = memory.robots[robot.name];
    const bool answers = before != nullptr && i < before->robots.size() && before->robots[i].command;
    if (answers || line.held != 0 || line.step == 0) known.answered = true;
    if (answers || line.held != 0) {
      known.forced = line.held == 0 && before->robots[i].command->kind == CommandKind::force;
      known.steps = answers ? before->robots[i].command->motion_steps : 0;
    }
    if (robot.command) known.by[line.process] = {line.number, line.tick};
    remember_superior(line, robot, known);
  }
}

void remember_steps(const Line& line, const Line* before, InstructionMemory& instruction) {
  if (before != nullptr && line.held == 0 && !line.broken_off())
    instruction.skew = std::max(instruction.skew, spread(line));
  else if (line.step != 0)
    instruction.skew_is_known = false;
  if (!line.ends() && instruction.goes_on_with.size() < kValuesKept)
    instruction.goes_on_with.insert(key_of(line.conditions));
}

bool share_a_robot(const Line& a, const Line& b) {
  for (const RobotEntry& one : a.robots)
    for (const RobotEntry& other : b.robots)
      if (one.name == other.name) return true;
  return false;
}

}  // namespace

const CommandEntry* RobotMemory::wish_of(const Line& line, const RobotEntry& robot) const {
  const bool of_mp = robot.command && line.process != robot.name;
  if (!robot.superior && !of_mp) return nullptr;
  const std::optional<Side>& other = robot.superior ? wished : followed;
  return other && other->tick == robot.tick ? &other->command : nullptr;
}

const ProcessMemory* Memory::process(const std::string& name) const { return find_in(processes, name); }

const RobotMemory* Memory::robot(const std::string& name) const { return find_in(robots, name); }

const InstructionMemory* Memory::instruction(const Line& line) const {
  const ProcessMemory* known = process(line.process);
  return known == nullptr ? nullptr : find_in(known->open, line.instruction);
}

const Line* Memory::before(const Line& line) const {
  const InstructionMemory* known = instruction(line);
  return known == nullptr || known->interrupted || !follows(line, known->before) ? nullptr : &known->before;
}

bool Memory::began_before(const Line& line) const {
  return black_box && line.step != 0 && instruction(line) == nullptr;
}

void Memory::take(const Line& line) {
  ProcessMemory& process = processes[line.process];
  ++lines;
  ++process.lines;
  process.last_line = line.number;
  last_process = line.process;
  last_made = line.made;
  const bool begins = line.instruction > process.last_instruction || began_before(line);
  if (begins) {
    process.last_instruction = std::max(process.last_instruction, line.instruction);
    ++instructions;
    // an instruction with the same robot is over, even without an end in the trace
    std::erase_if(process.open, [&line](const auto& other) { return share_a_robot(line, other.second.before); });
  }
  if (began_before(line))  // with several processes in a black box, another one may have commanded these robots before
    for (const RobotEntry& robot : line.robots) robots[robot.name].answered = robots[robot.name].forced = false;
  if (!line.cut) remember_robots(line, before(line), *this, process);
  for (const SensorEntry& sensor : line.sensors) process.sensors[sensor.name] = sensor;
  if (line.ends()) {
    process.open.erase(line.instruction);
    return;
  }
  if (!begins && !process.open.contains(line.instruction)) return;  // it has ended already
  const Line* known = before(line);
  InstructionMemory& instruction = process.open[line.instruction];
  remember_steps(line, known, instruction);
  instruction.interrupted = line.cut;
  instruction.before = line;
}

void Memory::take(const ProcessEnd& end) { processes[end.process].ended = true; }

std::string key_of(const std::vector<ConditionEntry>& conditions) {
  std::string key;
  for (const ConditionEntry& condition : conditions) key += condition.value ? '1' : '0';
  return key;
}

Tick spread(const Line& line) {
  Tick first = kNever, last = 0;
  for (const RobotEntry& robot : line.robots) {
    first = std::min(first, robot.macrostep);
    last = std::max(last, robot.macrostep);
  }
  return line.robots.empty() ? 0 : last - first;
}

}  // namespace mrroc::cli::trace
