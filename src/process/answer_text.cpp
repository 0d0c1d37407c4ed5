#include "process/answer_text.hpp"

#include <cmath>

#include "config/text/message_text.hpp"
#include "core/number_text.hpp"

namespace mrroc::process {

namespace {

std::string trimmed(const std::string& line) {
  constexpr const char* kBlanks = " \t\r";
  const std::size_t first = line.find_first_not_of(kBlanks);
  return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(kBlanks) - first + 1);
}

std::optional<double> as_number(const std::string& text) { return core::to_finite(text); }

std::optional<double> as_choice(const links::OperatorQuestion& question, const std::string& text) {
  for (std::size_t i = 0; i < question.choice_count; ++i)
    if (question.choices[i].view() == text) return static_cast<double>(i);
  const auto number = as_number(text);
  if (!number || *number != std::floor(*number) || *number < 1 || *number > question.choice_count) return std::nullopt;
  return *number - 1;
}

std::optional<double> as_yes_no(const std::string& text) {
  if (text == "yes" || text == "y") return 1;
  if (text == "no" || text == "n") return 0;
  return std::nullopt;
}

}  // namespace

std::string expected_answer(const links::OperatorQuestion& question) {
  switch (question.kind) {
    case links::QuestionKind::none:
      return "no answer";
    case links::QuestionKind::yes_no:
      return "yes or no";
    case links::QuestionKind::choice: {
      std::vector<std::string> choices;
      for (std::size_t i = 0; i < question.choice_count; ++i) choices.emplace_back(question.choices[i].view());
      return config::alternatives(choices);
    }
    case links::QuestionKind::number:
      break;
  }
  return config::expected_number({.min = question.minimum, .max = question.maximum});
}

bool is_answer(const links::OperatorQuestion& question, double value) {
  if (question.kind == links::QuestionKind::number) return value >= question.minimum && value <= question.maximum;
  const int choices = question.kind == links::QuestionKind::yes_no ? 2 : question.choice_count;
  return value >= 0 && value < choices && value == std::floor(value);
}

std::optional<double> read_answer(const links::OperatorQuestion& question, const std::string& line,
                                  std::string& refusal) {
  const std::string text = trimmed(line);
  std::string fault = " is not an answer";
  if (question.kind == links::QuestionKind::number) {
    const auto value = as_number(text);
    if (value && *value >= question.minimum && *value <= question.maximum) return value;
    fault = value ? " is out of range" : std::string(" ").append(core::number_problem(text));
  } else {
    const auto value = question.kind == links::QuestionKind::choice ? as_choice(question, text) : as_yes_no(text);
    if (value) return value;
  }
  refusal = config::in_quotes(text) + fault + ", expected " + expected_answer(question);
  return std::nullopt;
}

}  // namespace mrroc::process
