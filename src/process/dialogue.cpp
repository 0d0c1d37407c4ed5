#include "process/dialogue.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "config/text/message_text.hpp"
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
  links::OperatorAnswer answer;
  while (link_.take(answer)) {  // to an earlier question
  }
  if (const config::Answer* prepared = next_answer(text)) {
    value = read(*prepared, question);
    tell((text + " " + prepared->answer).substr(0, kLongestText));
  } else {
    number = link_.ask(question);
  }
  for (;;) {
    while (link_.take(answer))
      if (number != 0 && (answer.question == number || answer.question == 0)) value = checked(answer, question);
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

/// An answer of an event has not been compared with the question before.
double Dialogue::checked(const links::OperatorAnswer& answer, const links::OperatorQuestion& question) const {
  if (is_answer(question, answer.value)) return answer.value;
  throw NonFatalError(ErrorCode::invalid_argument,
                      "the answer " + config::number_text(answer.value) + " of an event to '" +
                          std::string{question.text.view()} + "', expected " + expected_answer(question),
                      {process_.name(), "", 0, process_.clock().tick()});
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
