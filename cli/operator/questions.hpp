#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/operator/operator_events.hpp"
#include "clock/clock.hpp"
#include "config/deployment.hpp"
#include "links/transport/domain.hpp"
#include "links/wire/operator_messages.hpp"

namespace mrroc::cli {

/// Throws ConfigurationError when a sensor asks the operator and no answer is possible: no event of the deployment
/// answers, and `attended` is false or the clock is lockstep, where a live answer would arrive at another tick on every
/// run.
void check_somebody_answers(const config::Deployment& deployment, bool attended);

/// A question that waits for the operator's answer.
struct OpenQuestion {
  std::string asker;         ///< sensor or process
  std::uint64_t number = 0;  ///< of the asker's questions, from 1
  links::OperatorQuestion question;

  std::string text() const { return asker + ": " + std::string{question.text.view()}; }
  bool same(const OpenQuestion& other) const { return asker == other.asker && number == other.number; }
};

/// Collects the questions and messages of sensors and task programs. A sensor's question is answered by the first event
/// for it at a later tick; all others stay open, the oldest first, except for the one that is shown. A repeated
/// question replaces the earlier one of its asker. Messages are shown at once. Main thread.
class Questions {
 public:
  using Show = std::function<void(const std::string& line)>;

  /// Opens the links of all askers of the deployment. `show`: displays a line. All outlive it.
  Questions(const config::Deployment& deployment, links::Domain& domain, clock::Clock& clock, Show show);

  /// Takes new questions and messages, in the order in which they were asked.
  void poll();
  /// Throws NonFatalError(sensor_not_ready) when a question is open: no answer can come.
  void refuse_open() const;
  /// The open questions; the first is the one to show.
  const std::deque<OpenQuestion>& open() const noexcept { return open_; }
  /// The open question of an asker, of the first one for an empty name; null when there is none.
  const OpenQuestion* find(std::string_view asker) const noexcept;
  /// Removes the question of this asker: it has been answered.
  void close(const std::string& asker);
  /// From now on the first question stays the first until it is closed.
  void mark_shown();

  OperatorEvents::AnswerLinks& links() noexcept { return links_; }

 private:
  void take(const OpenQuestion& question);
  const config::Event* event_for(const std::string& asker, Tick asked) const noexcept;

  const config::Deployment& deployment_;
  Show show_;
  OperatorEvents::AnswerLinks links_;
  std::deque<OpenQuestion> open_;
  OpenQuestion shown_;
};

}  // namespace mrroc::cli
