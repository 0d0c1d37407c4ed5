#include "cli/operator/questions.hpp"

#include <algorithm>

#include "config/entries/operator_answer.hpp"
#include "config/table.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::cli {

namespace {

bool earlier(const OpenQuestion& a, const OpenQuestion& b) { return a.question.tick < b.question.tick; }

}  // namespace

void check_somebody_answers(const config::Deployment& deployment, bool attended) {
  const bool lockstep = deployment.clock == config::ClockMode::lockstep;
  if (attended && !lockstep) return;
  for (const config::SensorEntry& sensor : deployment.sensors) {
    const auto answers = [&](const config::Event& event) { return event.asker == sensor.name; };
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

Questions::Questions(const config::Deployment& deployment, links::Domain& domain, clock::Clock& clock, Show show)
    : deployment_(deployment), show_(std::move(show)) {
  const auto open_link = [&](const std::string& asker) {
    links_[asker] = std::make_unique<links::OperatorResponder>(domain, clock, deployment.name + "/" + asker);
  };
  for (const config::SensorEntry& sensor : deployment.sensors)
    if (config::asks_operator(sensor)) open_link(sensor.name);
  open_link("mp");
  for (const config::RobotEntry& robot : deployment.robots) open_link(robot.name);
}

void Questions::poll() {
  std::vector<OpenQuestion> taken;
  OpenQuestion question;
  for (const auto& [name, link] : links_) {
    question.asker = name;
    while (link->take(question.question, question.number)) taken.push_back(question);
  }
  std::stable_sort(taken.begin(), taken.end(), earlier);
  for (const OpenQuestion& each : taken) take(each);
}

void Questions::take(const OpenQuestion& question) {
  if (question.question.kind == links::QuestionKind::none) {
    show_(question.text());
    return;
  }
  close(question.asker);  // asked again
  if (const config::Event* event = event_for(question.asker, question.question.tick)) {
    show_(question.text() + " (answered at tick " + std::to_string(event->tick) + ")");
    return;
  }
  const auto waiting = open_.begin() + (!open_.empty() && open_.front().same(shown_) ? 1 : 0);
  open_.insert(std::upper_bound(waiting, open_.end(), question, earlier), question);
}

void Questions::refuse_open() const {
  if (open_.empty()) return;
  throw NonFatalError(ErrorCode::sensor_not_ready, open_.front().text() + " No operator is left to answer",
                      {"", open_.front().asker, 0, 0});
}

const config::Event* Questions::event_for(const std::string& asker, Tick asked) const noexcept {
  for (const config::Event& event : deployment_.events)
    if (event.asker == asker && event.tick > asked) return &event;
  return nullptr;
}

const OpenQuestion* Questions::find(std::string_view asker) const noexcept {
  for (const OpenQuestion& question : open_)
    if (asker.empty() || question.asker == asker) return &question;
  return nullptr;
}

void Questions::close(const std::string& asker) {
  std::erase_if(open_, [&](const OpenQuestion& question) { return question.asker == asker; });
}

void Questions::mark_shown() { shown_ = open_.empty() ? OpenQuestion{} : open_.front(); }

}  // namespace mrroc::cli
