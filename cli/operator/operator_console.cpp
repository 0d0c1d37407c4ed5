#include "cli/operator/operator_console.hpp"

#include <algorithm>
#include <vector>

#include "config/entries/operator_answer.hpp"
#include "config/table.hpp"
#include "mrroc/errors.hpp"
#include "process/answer_text.hpp"

namespace mrroc::cli {

void check_somebody_answers(const config::Deployment& deployment, bool attended) {
  const bool lockstep = deployment.clock == config::ClockMode::lockstep;
  if (attended && !lockstep) return;
  for (const config::SensorEntry& sensor : deployment.sensors) {
    const auto answers = [&](const config::Event& event) { return event.sensor == sensor.name; };
    if (!config::asks_operator(sensor) || std::any_of(deployment.events.begin(), deployment.events.end(), answers)) {
      continue;
    }
    throw config::ConfigurationError(
        deployment.file, 0, "sensors." + sensor.name,
        std::string{"asks the operator, and no answer can be typed under "} +
            (lockstep ? "the clock 'lockstep'" : "a standard input that is not a terminal"),
        "an event that answers: [[events]] with tick, command = 'answer', sensor and value");
  }
}

OperatorConsole::OperatorConsole(const config::Deployment& deployment, links::Domain& domain, clock::Clock& clock,
                                 ConsoleInput& input, Show show)
    : deployment_(deployment), emergency_stop_(clock.emergency_stop()), input_(input), show_(std::move(show)) {
  const auto open_link = [&](const std::string& asker) {
    links_[asker] = std::make_unique<links::OperatorResponder>(domain, clock, deployment.name + "/" + asker);
  };
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (config::asks_operator(sensor)) open_link(sensor.name);
  open_link("mp");
  for (const config::RobotEntry& robot : deployment.robots) open_link(robot.name);
}

void OperatorConsole::answer(const config::Event& event) { send(event.sensor, {0, event.value}); }

void OperatorConsole::emergency(const std::string& word) {
  if (word == "estop")
    emergency_stop_.press();
  else
    emergency_stop_.reset();
}

void OperatorConsole::poll() {
  while (const std::optional<std::string> word = input_.next_of({"estop", "reset"})) {
    emergency(*word);
    show_(*word == "estop" ? "emergency stop: every robot stops until the line 'reset'" : "emergency stop: reset");
  }
  take_questions();
  read_lines();
}

/// Takes new questions, in the order in which they were asked.
void OperatorConsole::take_questions() {
  std::vector<Open> taken;
  Open open;
  for (const auto& [name, link] : links_) {
    open.asker = name;
    while (link->take(open.question, open.number)) taken.push_back(open);
  }
  const auto earlier = [](const Open& a, const Open& b) { return a.question.tick < b.question.tick; };
  std::stable_sort(taken.begin(), taken.end(), earlier);
  for (const Open& question : taken) take_question(question);
}

void OperatorConsole::take_question(const Open& open) {
  if (open.question.kind == links::QuestionKind::none) {
    show_(open.text());
    return;
  }
  std::erase_if(open_, [&](const Open& other) { return other.asker == open.asker; });  // asked again
  if (const config::Event* event = event_for(open.asker, open.question.tick)) {
    show_(open.text() + " (answered at tick " + std::to_string(event->tick) + ")");
    return;
  }
  if (!somebody_types()) refuse(open);
  // the oldest first, except the one that the operator is answering
  const auto waiting = open_.begin() + (!open_.empty() && open_.front().same(shown_) ? 1 : 0);
  const auto later = [](const Open& a, const Open& b) { return a.question.tick < b.question.tick; };
  open_.insert(std::upper_bound(waiting, open_.end(), open, later), open);
}

const config::Event* OperatorConsole::event_for(const std::string& asker, Tick asked) const noexcept {
  for (const config::Event& event : deployment_.events)
    if (event.sensor == asker && event.tick > asked) return &event;
  return nullptr;
}

bool OperatorConsole::somebody_types() const noexcept {
  return deployment_.clock != config::ClockMode::lockstep && input_.attended();
}

void OperatorConsole::refuse(const Open& question) const {
  throw NonFatalError(ErrorCode::sensor_not_ready, question.text() + " No operator is left to answer",
                      {"", question.asker, 0, 0});
}

void OperatorConsole::ask_aloud() {
  if (open_.front().same(shown_)) return;
  shown_ = open_.front();
  show_(shown_.text() + " (" + process::expected_answer(shown_.question) + ")");
}

void OperatorConsole::read_lines() {
  while (!open_.empty()) {
    ask_aloud();
    const std::optional<std::string> line = input_.next();
    if (!line && !input_.attended()) refuse(open_.front());
    if (!line) return;
    const Open& open = open_.front();
    std::string refusal;
    if (const auto value = process::read_answer(open.question, *line, refusal)) {
      send(open.asker, {open.number, *value});
      open_.pop_front();
    } else {
      show_(open.asker + ": " + refusal);
    }
  }
}

void OperatorConsole::send(const std::string& asker, const links::OperatorAnswer& answer) {
  const std::lock_guard lock(sending_);
  links_.at(asker)->answer(answer);
}

}  // namespace mrroc::cli
