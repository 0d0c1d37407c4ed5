#include "config/state_machine.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "config/table.hpp"
#include "config/text/message_text.hpp"
#include "config/text/parcel_of_table.hpp"

namespace mrroc::config {

namespace {

struct Reader {
  const Deployment& deployment;
  const ProgramsByRobot& programs;
  std::vector<std::string> targets;  ///< every state, and the end
  ProgramBehaviours none{};

  /// A program without output has no behaviours.
  const ProgramBehaviours& of(const std::string& robot) const {
    const auto found = programs.find(robot);
    return found != programs.end() ? found->second : none;
  }
  std::string target(const Table& table, std::string_view key) const { return table.choice(key, targets); }
  State::Start start(const Table& table) const;
  void transitions(const Table& table, State& state) const;
  State state(const Table& table, const std::string& name) const;
};

State::Start Reader::start(const Table& table) const {
  std::vector<std::string> robots;
  for (const RobotEntry& robot : deployment.robots) robots.push_back(robot.name);
  State::Start start;
  start.robot = table.choice("robot", robots);
  if (!table.has("behaviour")) {
    table.finish();
    return start;
  }
  const std::vector<MessageSchema>& known = of(start.robot).on;
  std::vector<std::string> labels;
  labels.reserve(known.size());
  for (const MessageSchema& schema : known) labels.push_back(schema.label);
  const std::string label = table.choice("behaviour", labels);
  const auto schema =
      std::find_if(known.begin(), known.end(), [&](const MessageSchema& one) { return one.label == label; });
  start.behaviour = parcel_of(table, *schema);
  start.arguments = arguments_text(table, *schema);
  table.finish();
  return start;
}

void Reader::transitions(const Table& table, State& state) const {
  state.next = target(table, "next");
  state.any = table.has("until") && table.choice("until", {"all", "any"}) == "any";
  if (table.has("on_error")) state.on_error = target(table, "on_error");
  const auto on = table.optional_table("on");
  if (!on) return;
  std::vector<std::string> reported;
  for (const State::Start& start : state.starts) {
    const auto& tells = of(start.robot).tells;
    reported.insert(reported.end(), tells.begin(), tells.end());
  }
  for (const std::string& label : on->keys()) {
    if (std::find(reported.begin(), reported.end(), label) == reported.end())
      on->fail(label, "no robot that this state starts sends it", alternatives(reported));
    state.on.emplace_back(label, target(*on, label));
  }
}

State Reader::state(const Table& table, const std::string& name) const {
  State state;
  state.name = name;
  if (table.has("ask")) {
    table.only({"ask", "yes", "no", "at_most", "afterwards"});
    state.question = table.text("ask");
    state.yes = target(table, "yes");
    state.no = target(table, "no");
  } else {
    table.only({"start", "until", "next", "on", "on_error", "at_most", "afterwards"});
    for (const Table& start : table.tables("start")) {
      state.starts.push_back(this->start(start));
      const auto twice = [&](const State::Start& other) { return other.robot == state.starts.back().robot; };
      if (std::count_if(state.starts.begin(), state.starts.end(), twice) > 1)
        start.fail("robot", in_quotes(state.starts.back().robot) + " is started twice", "each robot once in a state");
    }
    if (state.starts.empty())
      table.fail("start", "nothing is started", "start = [{ robot = ..., behaviour = ... }], or ask");
    transitions(table, state);
  }
  if (table.has("at_most") || table.has("afterwards")) {
    state.at_most = table.integer("at_most", 1, 1'000'000'000);
    state.afterwards = target(table, "afterwards");
  }
  return state;
}

std::vector<std::string> followers(const State& state) {
  std::vector<std::string> names{state.next, state.yes, state.no, state.on_error, state.afterwards};
  for (const auto& [label, next] : state.on) names.push_back(next);
  std::erase(names, "");
  return names;
}

std::set<std::string> reached_from(const StateMachine& machine, const std::string& first) {
  std::set<std::string> reached;
  std::vector<std::string> open{first};
  while (!open.empty()) {
    const std::string name = open.back();
    open.pop_back();
    if (!reached.insert(name).second || name == kEndState) continue;
    for (const std::string& next : followers(machine.state(name))) open.push_back(next);
  }
  return reached;
}

void check_ways(const Table& states, const StateMachine& machine) {
  const std::set<std::string> reached = reached_from(machine, machine.first);
  for (const State& state : machine.states) {
    if (!reached.contains(state.name))
      states.fail(state.name, "no transition leads to this state",
                  "a path from the first, " + in_quotes(machine.first));
    if (!reached_from(machine, state.name).contains(kEndState))
      states.fail(state.name, "the task can never end from this state", "a path to 'end'");
  }
}

}  // namespace

const State& StateMachine::state(const std::string& name) const {
  const auto found = std::find_if(states.begin(), states.end(), [&](const State& one) { return one.name == name; });
  if (found == states.end()) throw std::logic_error("no state " + in_quotes(name));
  return *found;
}

StateMachine load_state_machine(const std::filesystem::path& file, const Deployment& deployment,
                                const ProgramsByRobot& programs) {
  const Table root = Table::load(file);
  root.only({"first", "states"});
  const Table states = root.table("states");
  Reader reader{deployment, programs, states.table_names()};
  StateMachine machine{file, root.choice("first", reader.targets), {}};
  for (const std::string& name : states.table_names())
    if (name == kEndState) states.fail(name, "is the end of the task", "another name");
  reader.targets.emplace_back(kEndState);
  for (const std::string& name : states.table_names()) machine.states.push_back(reader.state(states.table(name), name));
  check_ways(states, machine);
  return machine;
}

}  // namespace mrroc::config
