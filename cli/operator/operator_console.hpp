#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "cli/operator/console_input.hpp"
#include "clock/clock.hpp"
#include "config/deployment.hpp"
#include "links/exchange/operator_responder.hpp"
#include "links/transport/domain.hpp"

namespace mrroc::cli {

/// Throws ConfigurationError when a sensor asks the operator and no answer is possible: no event of the deployment
/// answers, and `attended` is false or the clock is lockstep, where a typed answer would arrive at another tick on
/// every run.
void check_somebody_answers(const config::Deployment& deployment, bool attended);

/// Collects the questions and messages of sensors and task programs for the operator, and sends the operator's answers:
/// those of the deployment's events at their ticks, typed ones at once. A sensor's question is answered by the first
/// event for it at a later tick. A program's question, and a sensor's without an event, is shown, the oldest first, and
/// repeated until the typed line is an answer. Messages are shown at once. Main thread, except `answer`.
class OperatorConsole {
 public:
  using Show = std::function<void(const std::string& line)>;

  /// `clock`: the operator's; `input`: where answers are typed; `show`: displays a line. All outlive the console.
  OperatorConsole(const config::Deployment& deployment, links::Domain& domain, clock::Clock& clock, ConsoleInput& input,
                  Show show);

  /// Sends the answer of an event. The clock's thread, at the event's tick.
  void answer(const config::Event& event);
  /// `estop` or `reset` of an event: presses or resets the emergency stop of all robots. Any thread.
  void emergency(const std::string& word);
  /// Checks for questions and for typed lines: the words `estop` and `reset` at any time, before every answer. Throws
  /// NonFatalError(sensor_not_ready) for a question that no operator is left to answer.
  void poll();
  /// Whether a question waits for a typed line.
  bool waits_for_line() const noexcept { return !open_.empty(); }

 private:
  struct Open {
    std::string asker;  // sensor or process
    std::uint64_t number = 0;
    links::OperatorQuestion question;
    std::string text() const { return asker + ": " + std::string{question.text.view()}; }
    bool same(const Open& other) const { return asker == other.asker && number == other.number; }
  };

  void take_questions();
  void take_question(const Open& open);
  const config::Event* event_for(const std::string& asker, Tick asked) const noexcept;
  bool somebody_types() const noexcept;
  [[noreturn]] void refuse(const Open& question) const;
  void ask_aloud();
  void read_lines();
  void send(const std::string& asker, const links::OperatorAnswer& answer);

  const config::Deployment& deployment_;
  clock::EmergencyStop& emergency_stop_;
  ConsoleInput& input_;
  Show show_;
  std::map<std::string, std::unique_ptr<links::OperatorResponder>> links_;  // by asker
  std::deque<Open> open_;                                                   // the first is the one shown
  Open shown_;
  std::mutex sending_;
};

}  // namespace mrroc::cli
