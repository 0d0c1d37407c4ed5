#include "sensors/operator_input/operator_source.hpp"

#include <exception>

#include "config/entries/operator_answer.hpp"

namespace mrroc::vsp {

OperatorSource::OperatorSource(const config::SensorEntry& entry, links::Domain& domain, clock::Clock& clock,
                               const std::string& prefix, double timeout)
    : entry_(&entry), link_(domain, clock, prefix) {
  link_.connect(timeout);
}

SourceState OperatorSource::read(Tick wanted, RawReading& raw) noexcept {
  links::OperatorAnswer answer;
  while (link_.take(answer)) {
    const bool of_the_open = open_ != 0 && (answer.question == 0 || answer.question == open_);
    if (!of_the_open || !config::is_answer(*entry_, answer.value)) continue;
    open_ = 0;
    ++answers_;
    value_ = answer.value;
  }
  if (lost_) return SourceState::silent;
  raw.tick = wanted;
  raw.count = 2;
  raw.values[0] = answers_;
  raw.values[1] = value_;
  return SourceState::ready;
}

void OperatorSource::ask(Tick tick) noexcept {
  try {
    const config::Range answers = config::answers_of(*entry_);
    links::OperatorQuestion question;
    question.text.assign(entry_->texts.at("question"));
    question.minimum = answers.min;
    question.maximum = answers.max;
    question.tick = tick;
    open_ = link_.ask(question);
  } catch (const std::exception&) {
    lost_ = true;
  }
}

}  // namespace mrroc::vsp
