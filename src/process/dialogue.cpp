#include "process/dialogue.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "mrroc/errors.hpp"
#include "mrroc/stopped.hpp"
#include "process/answer_text.hpp"

namespace mrroc::process {

namespace {

constexpr std::size_t kLongestText = 127;

void check_text(const std::string& text) {
  if (!text.empty() && text.size() <= kLongestText) return;
  throw NonFatalError(ErrorCode::invalid_argument, "a text of " + std::to_string(text.size()) +
                                                       " characters for the operator, expected 1 to " +
                                                       std::to_string(kLongestText) + ": '" + text.substr(0, 40) + "'");
}

}  // namespace

Dialogue::Dialogue(Process& process)
    : process_(process), link_(process.domain(), process.clock(), process.topic(process.name())) {}

void Dialogue::tell(const std::string& text) {
  check_text(text);
  links::OperatorQuestion message;
  message.kind = links::QuestionKind::none;
  message.text.assign(text);
  message.tick = process_.clock().tick();
  link_.ask(message);
}

double Dialogue::ask(links::OperatorQuestion question, const std::string& text, const std::function<bool()>& go_on) {
  check_text(text);
  question.text.assign(text);
  question.tick = process_.clock().tick();
  std::optional<double> value;
  std::uint64_t number = 0;
  if (const config::Answer* answer = next_answer(text)) {
    value = read(*answer, question);
    tell((text + " " + answer->answer).substr(0, kLongestText));
  } else {
    number = link_.ask(question);
  }
  for (;;) {
    links::OperatorAnswer answer;
    while (link_.take(answer))
      if (answer.question == number) value = answer.value;
    if (go_on() && value) return *value;
    if (process_.clock().wait(kNever) == clock::Wake::interrupted) throw Stopped{};
  }
}

const config::Answer* Dialogue::next_answer(const std::string& text) {
  std::vector<const config::Answer*> answers;
  for (const config::Answer& answer : process_.deployment().answers)
    if (answer.question == text && (answer.process.empty() || answer.process == process_.name()))
      answers.push_back(&answer);
  if (answers.empty()) return nullptr;
  return answers[std::min(asked_[text]++, answers.size() - 1)];
}

double Dialogue::read(const config::Answer& answer, const links::OperatorQuestion& question) const {
  std::string refusal;
  const auto value = read_answer(question, answer.answer, refusal);
  if (value) return *value;
  throw NonFatalError(ErrorCode::invalid_argument, process_.deployment().file.string() + ":" +
                                                       std::to_string(answer.line) + ": answers.answer: " + refusal +
                                                       " to '" + answer.question + "'");
}

}  // namespace mrroc::process
