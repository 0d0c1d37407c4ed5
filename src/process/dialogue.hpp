#pragma once

#include <functional>
#include <map>
#include <string>

#include "links/exchange/operator_requester.hpp"
#include "process/process.hpp"

namespace mrroc::process {

/// Messages and questions of a task program to the operator. The answers of the deployment ([[answers]]) to a question
/// are used at once, in order: the first, then the second; the last one is repeated. Without one the dialogue waits for
/// the operator. Task's thread.
class Dialogue {
 public:
  explicit Dialogue(Process& process);

  /// Hand-shake with the operator's end, about `timeout` s at most; before the clock starts. Throws as links::connect.
  void connect(double timeout) { link_.connect(timeout); }

  /// Shows a message; does not wait. Throws NonFatalError(invalid_argument) for one of more than 127 characters.
  void tell(const std::string& text);

  /// Asks, and waits for the answer: a number, 1 or 0 for yes or no, the index of the choice. `go_on` is called
  /// whenever something has arrived: false keeps the dialogue waiting even after the answer (the task is paused); it
  /// throws to end it. Throws NonFatalError(invalid_argument) for a text of more than 127 characters, no choice or more
  /// than 8, or choices of more than 31; for an answer of the deployment that does not fit this question: with its file
  /// and line; for an answer of an event that does not fit it.
  double ask(links::OperatorQuestion question, const std::string& text, const std::function<bool()>& go_on);

 private:
  const config::Answer* next_answer(const std::string& text);
  double checked(const links::OperatorAnswer& answer, const links::OperatorQuestion& question) const;
  double read(const config::Answer& answer, const links::OperatorQuestion& question) const;

  Process& process_;
  links::OperatorRequester link_;
  std::map<std::string, std::size_t> asked_;  // how often
};

}  // namespace mrroc::process
