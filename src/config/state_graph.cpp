#include "config/state_machine.hpp"

namespace mrroc::config {

namespace {

/// Text between the quotes of a DOT string.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string node(const State& state) {
  std::string label = escaped(state.name);
  for (const State::Start& start : state.starts) {
    label += "\\n" + escaped(start.robot);
    if (!start.behaviour.label.empty()) label += ": " + std::string{start.behaviour.label.view()};
    if (!start.arguments.empty()) label += " (" + escaped(start.arguments) + ")";
  }
  if (!state.question.empty()) label += "\\n" + escaped(state.question);
  const char* const shape = state.question.empty() ? "box, style=rounded" : "diamond";
  return "  \"" + escaped(state.name) + "\" [shape=" + shape + ", label=\"" + label + "\"];\n";
}

std::string edge(const State& from, const std::string& to, const std::string& label, const char* style = "") {
  if (to.empty()) return "";
  return "  \"" + escaped(from.name) + "\" -> \"" + escaped(to) + "\" [label=\"" + escaped(label) + "\"" + style +
         "];\n";
}

}  // namespace

std::string to_dot(const StateMachine& machine) {
  std::string text =
      "digraph task {\n  node [fontname=\"Helvetica\", fontsize=11];\n  edge [fontname=\"Helvetica\", fontsize=10];\n"
      "  \"\" [shape=point];\n  \"end\" [shape=doublecircle];\n  \"\" -> \"" +
      escaped(machine.first) + "\";\n";
  for (const State& state : machine.states) text += node(state);
  for (const State& state : machine.states) {
    const char* const done = state.starts.size() < 2 ? "" : state.any ? "one has ended" : "all have ended";
    text += edge(state, state.next, done);
    text += edge(state, state.yes, "yes") + edge(state, state.no, "no");
    for (const auto& [label, next] : state.on) text += edge(state, next, label);
    text += edge(state, state.on_error, "non-fatal error", ", style=dashed");
    text += edge(state, state.afterwards, "entered " + std::to_string(state.at_most) + " times", ", style=dotted");
  }
  return text + "}\n";
}

}  // namespace mrroc::config
