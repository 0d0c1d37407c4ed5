#include "cli/operator_desk.hpp"

#include <algorithm>

#include "cli/typed_answer.hpp"
#include "config/operator_answer.hpp"
#include "config/table.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::cli {

void check_somebody_answers(const config::Deployment& deployment, bool attended) {
  const bool lockstep = deployment.clock == config::ClockMode::lockstep;
  if (attended && !lockstep) return;
  for (const config::SensorEntry& sensor : deployment.sensors) {
    const auto answers = [&](const config::Event& event) { return event.sensor == sensor.name; };
    if (!config::asks_operator(sensor) || std::any_of(deployment.events.begin(), deployment.events.end(), answers)) {
      continue;
    }
    throw config::ConfigurationError(deployment.file, 0, "sensors." + sensor.name,
                                     std::string{"asks the operator, and nobody answers under "} +
                                         (lockstep ? "the clock 'lockstep'" : "a standard input that is no terminal"),
                                     "an event that does: [[events]] with tick, command = 'answer', sensor and value");
  }
}

OperatorDesk::OperatorDesk(const config::Deployment& deployment, links::Domain& domain, clock::Clock& clock,
                           TypedLines& input, Show show)
    : deployment_(deployment), input_(input), show_(std::move(show)) {
  for (const config::SensorEntry& sensor : deployment.sensors) {
    if (!config::asks_operator(sensor)) continue;
    links_[sensor.name] =
        std::make_unique<links::OperatorResponder>(domain, clock, deployment.name + "/" + sensor.name);
  }
}

void OperatorDesk::answer(const config::Event& event) { send(event.sensor, {0, event.value}); }

void OperatorDesk::look() {
  links::OperatorQuestion question;
  std::uint64_t number = 0;
  for (const auto& [name, link] : links_)
    while (link->take(question, number)) take_question(deployment_.sensor(name), question, number);
  read_lines();
}

void OperatorDesk::take_question(const config::SensorEntry& sensor, const links::OperatorQuestion& question,
                                 std::uint64_t number) {
  std::erase_if(open_, [&](const Open& open) { return open.sensor == &sensor; });  // asked anew
  const Open open{&sensor, number, question.tick, sensor.name + ": " + std::string{question.text.view()}};
  if (const config::Event* event = event_for(sensor.name, question.tick)) {
    show_(open.text + " (answered at tick " + std::to_string(event->tick) + ")");
    return;
  }
  if (!somebody_types()) refuse(open);
  // the oldest first, but for the one that somebody is answering
  const auto waiting = open_.begin() + (!open_.empty() && open_.front() == shown_ ? 1 : 0);
  const auto later = [](const Open& a, const Open& b) { return a.asked < b.asked; };
  open_.insert(std::upper_bound(waiting, open_.end(), open, later), open);
}

const config::Event* OperatorDesk::event_for(const std::string& sensor, Tick asked) const noexcept {
  for (const config::Event& event : deployment_.events)
    if (event.sensor == sensor && event.tick > asked) return &event;
  return nullptr;
}

bool OperatorDesk::somebody_types() const noexcept {
  return deployment_.clock != config::ClockMode::lockstep && input_.attended();
}

void OperatorDesk::refuse(const Open& question) const {
  throw NonFatalError(ErrorCode::sensor_not_ready, question.text + " Nobody is left to answer",
                      {"", question.sensor->name, 0, 0});
}

void OperatorDesk::ask_aloud() {
  if (open_.front() == shown_) return;
  shown_ = open_.front();
  show_(open_.front().text + " (" + expected_answer(*open_.front().sensor) + ")");
}

void OperatorDesk::read_lines() {
  while (!open_.empty()) {
    ask_aloud();
    const std::optional<std::string> line = input_.next();
    if (!line && !input_.attended()) refuse(open_.front());
    if (!line) return;
    const Open& open = open_.front();
    std::string refusal;
    if (const auto value = read_answer(*open.sensor, *line, refusal)) {
      send(open.sensor->name, {open.number, *value});
      open_.pop_front();
    } else {
      show_(open.sensor->name + ": " + refusal);
    }
  }
}

void OperatorDesk::send(const std::string& sensor, const links::OperatorAnswer& answer) {
  const std::lock_guard lock(sending_);
  links_.at(sensor)->answer(answer);
}

}  // namespace mrroc::cli
