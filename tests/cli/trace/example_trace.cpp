// A cell that follows the laws of Move and Wait, and writes the trace of a deployment.
#include <algorithm>
#include <map>

#include "cli/trace/trace_steps.hpp"

namespace mrroc::cli::trace {

namespace {

constexpr std::uint64_t kN = 10, kV = 8;

CommandEntry command(CommandKind kind, Numbers target = {}) {
  CommandEntry made;
  made.kind = kind;
  made.motion_steps = kN;
  made.reply_step = kV;
  made.target = std::move(target);
  return made;
}

CommandEntry hold() { return command(CommandKind::hold); }
CommandEntry joint(double first, double second) { return command(CommandKind::joint, {first, second}); }
CommandEntry pose(double x) { return command(CommandKind::pose, {x, 0.5, 0.25, 1, 0, 0, 0}); }

CommandEntry force() {
  CommandEntry made = command(CommandKind::force, {0, 0, 0.01, 0, 0, 0, 0, 0, -10, 0, 0, 0});
  made.behaviour = "uucggg";
  return made;
}

class Cell {
 public:
  Cell() {
    for (const char* name : {"arm", "belt", "slide"}) {
      RobotEntry& robot = robots_[name];
      robot.name = name;
      robot.desired = {0.5, -0.25};
      robot.desired_pose = robot.pose = {0.75, 0.5, 0.25, 1, 0, 0, 0};
    }
  }

  void begin(const std::string& process, const std::string& name, bool is_move, std::vector<std::string> robots,
             std::vector<SensorEntry> sensors = {}, std::optional<std::string> until = std::nullopt) {
    line_ = Line{};
    line_.process = process;
    line_.instruction = ++instructions_[process];
    line_.is_move = is_move;
    line_.name = name;
    line_.until = std::move(until);
    list_ = std::move(robots);
    for (const std::string& robot : list_) {
      robots_[robot].tick = now_;
      robots_[robot].desired_tick = std::max(robots_[robot].desired_tick, now_);
    }
    line_.sensors = std::move(sensors);
    read_sensors(true);
  }

  /// One step: the line, then the answer to its commands. `moving`: the robots continue moving after it.
  void step(std::vector<CommandEntry> commands, std::vector<ConditionEntry> conditions = {}, bool moving = false) {
    show(std::move(conditions));
    const Tick start = common_start();
    for (std::size_t i = 0; i < list_.size(); ++i) {
      CommandEntry made = commands.size() == 1 ? commands[0] : commands.at(i);
      if (list_.size() > 1) made.start_tick = start;
      line_.robots[i].command = made;
    }
    write();
    answer_all(moving);
    if (list_.empty()) now_ += 10;
    ++line_.step;
    line_.held = 0;
    read_sensors(false);
  }

  /// Equation (11): the MP ("station") and the ECP of `robot` each begin a Move with it.
  void begin_both(const std::string& robot) {
    now_ += 10;
    begin(robot, "Corrected", true, {robot});
    line_.obtained = true;
    of_ecp_ = line_;
    begin("station", "JointLine", true, {robot});
  }

  /// One step of both: the MP commands `wished`, the ECP makes `made` of it.
  void step_of_both(const CommandEntry& wished, const CommandEntry& made, bool moving) {
    std::swap(line_, of_ecp_);
    show({});
    line_.robots[0].command = made;
    line_.robots[0].superior = wished;
    write();
    std::swap(line_, of_ecp_);
    show({});
    line_.robots[0].coordination = Coordination::takes_part;
    line_.robots[0].command = wished;
    write();
    now_ = answer(robots_[list_[0]], made, moving);
    of_ecp_.obtained = false;
    ++of_ecp_.step;
    ++line_.step;
  }

  void end_both() {
    for (const Coordination coordination : {Coordination::none, Coordination::takes_part}) {
      std::swap(line_, of_ecp_);
      robots_[list_[0]].coordination = coordination;
      end(StepEnding::generator);
      end(line_.process);
    }
    robots_[list_[0]].coordination = Coordination::none;
    now_ += 10;
  }

  /// The robots held for so many macrosteps; the next line reports it.
  void pause(std::uint64_t macrosteps) {
    for (std::uint64_t i = 0; i < macrosteps; ++i)
      for (const std::string& name : list_) now_ = answer(robots_[name], hold(), false);
    line_.held = macrosteps;
    read_sensors(true);
  }

  void fail(const std::string& robot, ErrorClass error, const std::string& code) {
    robots_[robot].error = error;
    robots_[robot].error_code = code;
  }

  void end(StepEnding ending, std::vector<ConditionEntry> conditions = {}) {
    show(std::move(conditions));
    line_.ending = ending;
    if (ending == StepEnding::stopped) --line_.step;
    if (list_.size() > 1) line_.skew = 0;
    write();
    for (const std::string& name : list_) robots_[name].error = ErrorClass::none;
  }

  void end(const std::string& process) { trace_.items.emplace_back(ProcessEnd{0, process, lines_[process], 0, 0}); }

  /// Each step is made at the newest tick that its process has received.
  TraceSteps trace() {
    std::map<std::string, Tick> newest;
    for (Item& item : trace_.items)
      if (Line* const line = std::get_if<Line>(&item); line != nullptr)
        line->made = newest[line->process] = std::max(newest[line->process], line->tick);
    return trace_;
  }

 private:
  Tick end_of(const RobotEntry& robot) const {
    const auto forced = force_ends_.find(robot.name);
    return forced == force_ends_.end() ? robot.desired_tick : std::max(forced->second, robot.desired_tick);
  }

  Tick common_start() {
    Tick start = 0;
    bool moves = false;
    for (const std::string& name : list_) {
      start = std::max(start, robots_[name].desired_tick);
      moves = moves || robots_[name].moving;
    }
    return moves ? start : std::max(start, now_ + 2);
  }

  void answer_all(bool moving) {
    Tick newest = now_;
    for (const RobotEntry& robot : line_.robots)
      newest = std::max(newest, answer(robots_[robot.name], *robot.command, moving));
    now_ = newest;
  }

  /// The tick of the reply.
  Tick answer(RobotEntry& robot, const CommandEntry& made, bool moving) {
    const bool after_force = force_ends_.contains(robot.name) && made.kind != CommandKind::force;
    // 7 ticks of a stop after a force motion
    robot.macrostep = std::max({made.start_tick, end_of(robot) + (after_force ? 7 : 0), now_});
    robot.tick = robot.macrostep + made.reply_step;
    robot.desired_tick = robot.macrostep + made.motion_steps;
    force_ends_.erase(robot.name);
    if (made.kind == CommandKind::force) {
      force_ends_[robot.name] = robot.desired_tick;
      robot.desired_tick = robot.tick;
      robot.desired[0] += 0.001;
      robot.wrench = {0, 0, -9.5, 0.125, 0, 0};
    }
    if (made.kind == CommandKind::joint)
      for (std::size_t i = 0; i < robot.desired.size(); ++i)
        robot.desired[i] = (made.relative ? robot.desired[i] : 0) + made.target[i];
    if (made.kind == CommandKind::pose) {
      robot.desired_pose = made.target;
      robot.desired[1] += 0.002;
    }
    robot.moving = moving && made.kind != CommandKind::hold;
    return robot.tick;
  }

  void read_sensors(bool all) {
    for (SensorEntry& sensor : line_.sensors) {
      const bool due = all || line_.step % sensor.period == 0;
      if (sensor.mode == SensorMode::published) sensor.tick = now_ / 20 * 20;
      if (sensor.mode == SensorMode::polled && now_ > 5) sensor.tick = now_ - 5;
      if (sensor.mode == SensorMode::interactive && due) sensor.tick = now_;
      if (sensor.mode == SensorMode::interactive && due) sensor.values[0] = 0.5 * static_cast<double>(now_);
    }
  }

  void show(std::vector<ConditionEntry> conditions) {
    line_.conditions = std::move(conditions);
    line_.robots.clear();
    line_.tick = 0;
    for (const std::string& name : list_) {
      RobotEntry robot = robots_[name];
      robot.joints = robot.desired;
      robot.joints[0] += 1e-5;
      robot.pose = robot.desired_pose;
      line_.tick = std::max(line_.tick, robot.tick);
      line_.robots.push_back(robot);
    }
    for (const SensorEntry& sensor : line_.sensors) line_.tick = std::max(line_.tick, sensor.tick);
  }

  void write() {
    trace_.items.emplace_back(line_);
    ++lines_[line_.process];
  }

  TraceSteps trace_;
  std::map<std::string, RobotEntry> robots_;
  std::map<std::string, Tick> force_ends_;
  std::map<std::string, std::uint64_t> instructions_, lines_;
  std::vector<std::string> list_;
  Line line_, of_ecp_;
  Tick now_ = 40;
};

SensorEntry sensor(const std::string& name, std::size_t values, std::uint64_t period, SensorMode mode) {
  SensorEntry made;
  made.name = name;
  made.values.assign(values, 0.25);
  made.period = period;
  made.mode = mode;
  return made;
}

void arm_alone(Cell& cell) {
  const SensorEntry gate = sensor("gate", 2, 1, SensorMode::published);
  const SensorEntry wrist = sensor("wrist", 6, 2, SensorMode::interactive);
  const SensorEntry watch = sensor("watch", 1, 1, SensorMode::interactive);
  const SensorEntry eye = sensor("eye", 3, 1, SensorMode::polled);
  const std::string until = "wrist above 10 N or travelled 0.1 m";
  const auto parts = [](bool force_is, bool travelled) {
    return std::vector<ConditionEntry>{{"wrist above 10 N", force_is}, {"travelled 0.1 m", travelled}};
  };

  cell.begin("arm", "gate closer than 0.1 m", false, {"arm"}, {gate});
  for (int i = 0; i < 3; ++i) cell.step({hold()}, {{"gate closer than 0.1 m", false}});
  cell.end(StepEnding::condition, {{"gate closer than 0.1 m", true}});

  cell.begin("arm", "JointLine", true, {"arm"}, {wrist}, until);
  for (int i = 0; i < 4; ++i) cell.step({joint(0.5 + 0.01 * i, -0.25 - 0.02 * i)}, parts(false, false), i < 3);
  cell.end(StepEnding::generator, parts(false, false));

  cell.begin("arm", "ToolVelocity", true, {"arm"}, {wrist}, until);
  for (int i = 0; i < 3; ++i) cell.step({pose(0.75 + 0.01 * i)}, parts(false, false), true);
  cell.pause(2);
  for (int i = 0; i < 3; ++i) cell.step({pose(0.8 + 0.01 * i)}, parts(false, false), true);
  cell.end(StepEnding::condition, parts(false, true));

  cell.begin("arm", "ForceControl", true, {"arm"});
  for (int i = 0; i < 3; ++i) cell.step({force()}, {}, true);
  cell.end(StepEnding::end_motion);

  cell.begin("arm", "Hold", true, {"arm"});
  for (int i = 0; i < 3; ++i) cell.step({hold()});
  cell.end(StepEnding::generator);

  cell.begin("arm", "elapsed 2 steps", false, {}, {watch});
  for (int i = 0; i < 2; ++i) cell.step({}, {{"elapsed 2 steps", false}});
  cell.end(StepEnding::condition, {{"elapsed 2 steps", true}});

  cell.begin("arm", "Shift", true, {"arm"});
  CommandEntry relative = joint(0.125, -0.0625);
  relative.relative = true;
  for (int i = 0; i < 2; ++i) cell.step({relative});
  cell.fail("arm", ErrorClass::non_fatal, "a joint position limit would be passed");
  cell.end(StepEnding::non_fatal_error);

  cell.begin("arm", "Servo", true, {"arm"}, {eye});
  for (int i = 0; i < 3; ++i) cell.step({pose(0.7 + 0.01 * i)});
  cell.end(StepEnding::stopped);
  cell.end("arm");
}

void both_robots(Cell& cell) {
  cell.begin("mp", "Together", true, {"arm", "belt"});
  for (int i = 0; i < 4; ++i) cell.step({joint(0.25 + 0.01 * i, 0.125), hold()}, {}, i < 3);
  cell.end(StepEnding::generator);

  const auto parts = [](bool there, bool ready) {
    return std::vector<ConditionEntry>{{"there", there}, {"ready", ready}};
  };
  cell.begin("mp", "there and ready", false, {"arm", "belt"});
  cell.step({hold()}, parts(false, false));
  cell.step({hold()}, parts(true, false));
  cell.step({hold()}, parts(false, true));
  cell.end(StepEnding::condition, parts(true, true));
  cell.end("mp");
}

void with_its_ecp(Cell& cell) {
  cell.begin_both("slide");
  for (int i = 0; i < 4; ++i) cell.step_of_both(joint(0.375 + 0.01 * i, 0.0625), joint(0.5 + 0.01 * i, 0.0625), i < 3);
  cell.end_both();
}

}  // namespace

TraceSteps example_trace() {
  Cell cell;
  arm_alone(cell);
  with_its_ecp(cell);
  both_robots(cell);
  return cell.trace();
}

}  // namespace mrroc::cli::trace
