#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "cli/operator/operator_service.hpp"
#include "cli/operator/questions.hpp"
#include "cli/operator/terminal/console_input.hpp"

namespace mrroc::cli {

/// The operator at the run's own terminal or pipe: shows questions, one after the other, and takes typed lines. A line
/// is, in this order: `estop` or `reset`; an answer to the question that is shown; another verb. The space key pauses
/// and resumes. Verbs are executed at once, other lines of a pipe wait for a question. Main thread.
class OperatorConsole {
 public:
  using Show = std::function<void(const std::string& line)>;

  /// All outlive it. `show`: displays lines.
  OperatorConsole(OperatorService& service, Questions& questions, ConsoleInput& input, Show show);

  /// Takes new questions and typed lines. Throws NonFatalError(sensor_not_ready) for an open question when no answer
  /// can come: none from here, and `others_answer` is false.
  void poll(bool others_answer);
  /// Whether a question waits for a typed line.
  bool waits_for_line() const noexcept { return !questions_.open().empty(); }
  bool takes_keys() const noexcept { return input_.takes_keys(); }
  /// What is shown before the typed line of a terminal with single keys.
  std::string prompt() const;

 private:
  bool is_command(std::string_view line) const;
  bool is_answer(std::string_view line) const;
  void execute(const std::string& line);
  void toggle_pause();
  void request(const VerbRequest& request);
  void show_question();
  void read_answers();
  void help() const;

  OperatorService& service_;
  Questions& questions_;
  ConsoleInput& input_;
  Show show_;
  OpenQuestion shown_;
};

}  // namespace mrroc::cli
