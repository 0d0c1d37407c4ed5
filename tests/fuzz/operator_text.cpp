// Input of an operator: lines of any content from a file or a terminal, as answers to questions of any kind; and the
// texts that errors quote.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "cli/operator/terminal/console_input.hpp"
#include "config/text/message_text.hpp"
#include "core/nearest_word.hpp"
#include "fuzz/fuzz.hpp"
#include "fuzz/memory_file.hpp"
#include "process/answer_text.hpp"

namespace {

using mrroc::links::OperatorQuestion;
using mrroc::links::QuestionKind;

constexpr std::size_t kLongWord = 64;  // a distance costs the product of the lengths

bool is_printable(const std::string& text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

OperatorQuestion question_from(fuzz::Bytes& input) {
  OperatorQuestion question;
  question.kind = static_cast<QuestionKind>(input.take<std::uint8_t>() % 4);
  question.minimum = input.take<double>();
  question.maximum = input.take<double>();
  question.choice_count = static_cast<std::uint8_t>(input.take<std::uint8_t>() % (question.choices.size() + 1));
  for (auto& choice : question.choices) choice.assign(std::string{input.take_section().substr(0, 8)});
  return question;
}

void check_answer(const OperatorQuestion& question, const std::string& line) {
  std::string refusal;
  const auto answer = mrroc::process::read_answer(question, line, refusal);
  if (!answer) return fuzz::require(!refusal.empty() && is_printable(refusal), "a refusal is one line with a reason");
  fuzz::require(std::isfinite(*answer), "an answer is a finite number");
  if (question.kind == QuestionKind::number)
    fuzz::require(*answer >= question.minimum && *answer <= question.maximum, "an answer is in its range");
  if (question.kind == QuestionKind::choice)
    fuzz::require(*answer >= 0 && *answer < question.choice_count, "an answer is one of the choices");
}

void check_words(std::string_view a, std::string_view b) {
  a = a.substr(0, kLongWord), b = b.substr(0, kLongWord);
  const std::size_t distance = mrroc::core::edit_distance(a, b);
  fuzz::require(distance == mrroc::core::edit_distance(b, a), "a distance is symmetric");
  fuzz::require((distance == 0) == (a == b) && distance <= std::max(a.size(), b.size()), "a distance is a metric");
  const std::string best = mrroc::core::nearest_word(a, {std::string{b}, "a", ""});
  fuzz::require(best.empty() || best == b || best == "a", "the nearest is one of them");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  fuzz::Bytes input(data, size);
  const OperatorQuestion question = question_from(input);
  fuzz::require(!mrroc::process::expected_answer(question).empty(), "a question names the expected answer");
  const std::string_view typed = input.rest();
  const int descriptor = open(file.write(typed).c_str(), O_RDONLY | O_CLOEXEC);
  mrroc::cli::ConsoleInput lines(descriptor);
  std::string all, before;
  while (const auto line = lines.next()) {
    check_answer(question, *line);
    check_words(before, *line);
    fuzz::require(is_printable(mrroc::config::in_quotes(*line)), "a quotation is one line");
    all += *line + "\n";
    before = *line;
  }
  close(descriptor);
  const bool whole = typed.empty() || typed.back() == '\n';
  fuzz::require(all == std::string{typed} + (whole ? "" : "\n"), "every line is read, once");
  return 0;
}
