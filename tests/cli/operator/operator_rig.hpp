#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cli/operator/operator_events.hpp"
#include "cli/operator/operator_service.hpp"
#include "cli/operator/questions.hpp"
#include "config/deployment.hpp"
#include "links/exchange/operator_requester.hpp"
#include "links/exchange/task_subordinate.hpp"
#include "links/test_clock.hpp"
#include "links/test_domain.hpp"

namespace mrroc::cli {

inline const OperatorClient kA{1, "a"}, kB{2, "b"};

inline config::SensorEntry asking_sensor(const std::string& name) {
  config::SensorEntry sensor;
  sensor.name = name;
  sensor.type = "operator_input";
  sensor.source = "hardware";
  sensor.numbers = {{"min", {0}}, {"max", {9}}};
  return sensor;
}

/// A deployment "t" in which two sensors ask the operator.
inline config::Deployment asking_deployment(config::ClockMode clock) {
  config::Deployment deployment;
  deployment.name = "t";
  deployment.clock = clock;
  deployment.sensors = {asking_sensor("parts"), asking_sensor("weight")};
  return deployment;
}

inline links::OperatorQuestion number_question(const char* text, Tick tick) {
  links::OperatorQuestion question;
  question.text.assign(text);
  question.maximum = 9;
  question.tick = tick;
  return question;
}

/// The operator's side of a run and its MP, in one process: a message arrives when it is sent. Ticks begin when the
/// test wants it.
class OperatorRig {
 public:
  explicit OperatorRig(config::Deployment described = asking_deployment(config::ClockMode::paced), bool hold = false)
      : deployment(std::move(described)),
        task(net.domain, clock, "t/mp"),
        mp(net.domain, clock, "t/mp", "mp"),
        questions(deployment, net.domain, clock, [this](const std::string& line) { shown.push_back(line); }),
        robots(deployment, net.domain, clock),
        trajectories(deployment, net.domain, clock),
        events({[this](Tick at, clock::TickEvents::Callback callback) { schedule.add(at, std::move(callback)); },
                [this] { return tick; }},
               clock.emergency_stop(), mp, questions.links(), robots, trajectories,
               deployment.clock == config::ClockMode::real),
        service(deployment) {
    mp.connect(links::kPatience);
    service.publish_to([this](const std::string& json, const std::string& text) {
      published.push_back(json);
      if (!text.empty()) shown.push_back(text);
    });
    service.note_to([this](const config::Event& event) { noted.push_back(event); });
    events.schedule(deployment, hold);
    service.connect(events, questions, robots, trajectories);
  }

  /// Begins the next tick.
  void next_tick() {
    schedule.run(++tick);
    service.poll();
  }
  /// Sends a request of a client and returns the replies that it has received.
  const std::vector<VerbReply>& request(const OperatorClient& client, const std::string& line) {
    std::vector<VerbReply>& received = replies[client.number];
    VerbReply refusal;
    const auto parsed = parse_typed(line, refusal);
    if (parsed)
      service.request(client, *parsed, [&received](const VerbReply& reply) { received.push_back(reply); });
    else
      received.push_back(refusal);
    return received;
  }
  /// The commands that the MP has received since the last call.
  std::vector<links::TaskCommandKind> received() {
    std::vector<links::TaskCommandKind> kinds;
    for (links::TaskCommand command; task.take(command);) kinds.push_back(command.kind);
    return kinds;
  }

  links::TestDomain net;
  links::TestClock clock;
  config::Deployment deployment;
  clock::TickEvents schedule;
  Tick tick = -1;
  std::vector<std::string> shown, published;
  std::vector<config::Event> noted;
  std::map<std::uint64_t, std::vector<VerbReply>> replies;  // by client
  links::TaskSubordinate task;
  links::TaskSuperior mp;
  Questions questions;
  RobotOrders robots;
  Trajectories trajectories;
  OperatorEvents events;
  OperatorService service;
};

}  // namespace mrroc::cli
