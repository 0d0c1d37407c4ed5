#include "cli/operator/terminal/operator_console.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>

#include "cli/operator/operator_state.hpp"
#include "process/answer_text.hpp"

namespace mrroc::cli {

namespace {

OperatorClient terminal() { return {0, "the terminal"}; }

std::string first_word(std::string_view line) {
  std::string word{line.substr(0, line.find_first_of(" \t\r"))};
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  return word;
}

bool is_help(std::string_view line) { return line == "help" || line == "?"; }

}  // namespace

OperatorConsole::OperatorConsole(OperatorService& service, Questions& questions, ConsoleInput& input, Show show)
    : service_(service), questions_(questions), input_(input), show_(std::move(show)) {}

void OperatorConsole::poll(bool others_answer) {
  questions_.poll();
  const auto is_emergency = [](std::string_view line) {
    const std::string word = first_word(line);
    return word == "estop" || word == "reset";
  };
  while (const std::optional<std::string> line = input_.next_if(is_emergency)) execute(*line);
  show_question();
  while (const auto line = input_.next_if([this](std::string_view typed) { return is_command(typed); })) execute(*line);
  read_answers();
  if (!others_answer && !(service_.may_answer() && input_.attended())) questions_.refuse_open();
}

bool OperatorConsole::is_answer(std::string_view line) const {
  const OpenQuestion* const question = questions_.find("");
  std::string ignored;
  return question != nullptr && service_.may_answer() &&
         process::read_answer(question->question, std::string{line}, ignored).has_value();
}

bool OperatorConsole::is_command(std::string_view line) const {
  if (line == " " || is_help(line)) return true;
  if (is_answer(line)) return false;
  if (find_verb(first_word(line)) != nullptr) return true;
  // a terminal gets an answer to every line; lines of a pipe wait for the question that they answer
  return input_.takes_keys() && questions_.open().empty();
}

void OperatorConsole::execute(const std::string& line) {
  if (line == " ") return toggle_pause();
  if (line.empty()) return;
  if (is_help(line)) return help();
  const std::string word = first_word(line);
  VerbReply refusal;
  const auto typed = parse_typed(word + line.substr(word.size()), refusal);
  if (typed)
    request(*typed);
  else
    show_(to_text(refusal));
}

void OperatorConsole::toggle_pause() {
  VerbRequest toggled;
  toggled.verb = find_verb(service_.phase() == TaskPhase::paused ? "resume" : "pause");
  request(toggled);
}

void OperatorConsole::request(const VerbRequest& request) {
  const std::string name{request.verb->name};
  service_.request(terminal(), request, [this, name](const VerbReply& reply) {
    if (name == "status" && reply.ok())
      show_(state_text(reply.data));
    else
      show_(name + ": " + to_text(reply) + (reply.tick ? " [tick " + std::to_string(*reply.tick) + "]" : ""));
  });
}

void OperatorConsole::show_question() {
  if (questions_.open().empty() || questions_.open().front().same(shown_)) return;
  shown_ = questions_.open().front();
  questions_.mark_shown();
  show_(shown_.text() + " (" + process::expected_answer(shown_.question) + ")");
}

void OperatorConsole::read_answers() {
  while (!questions_.open().empty() && service_.may_answer()) {
    show_question();
    const std::optional<std::string> line = input_.next();
    if (!line) return;
    VerbRequest answer;
    answer.verb = find_verb("answer");
    answer.arguments["value"] = *line;
    const std::string asker = questions_.open().front().asker;
    service_.request(terminal(), answer, [this, asker](const VerbReply& reply) {
      if (!reply.ok()) show_(asker + ": " + to_text(reply));
    });
  }
}

std::string OperatorConsole::prompt() const {
  if (waits_for_line()) return "answer> " + input_.typed();
  if (!input_.typed().empty()) return "> " + input_.typed();
  return service_.phase() == TaskPhase::held ? "> (start: begins the task; help)" : "> (space: pause and resume; help)";
}

void OperatorConsole::help() const {
  std::string text;
  for (const OperatorVerb& verb : operator_verbs()) text += fmt::format("{:<33} {}\n", usage_of(verb), verb.summary);
  show_(text + "space                             pause, and resume");
}

}  // namespace mrroc::cli
