#include "cli/operator/operator_service.hpp"

#include <stdexcept>
#include <utility>
#include <vector>

#include "cli/operator/operator_state.hpp"
#include "config/entries/robot_orders.hpp"
#include "config/text/message_text.hpp"
#include "core/number_text.hpp"
#include "mrroc/errors.hpp"
#include "process/answer_text.hpp"

namespace mrroc::cli {

OperatorService::OperatorService(const config::Deployment& deployment) : deployment_(deployment) {}

void OperatorService::connect(OperatorEvents& events, Questions& questions, RobotOrders& robots,
                              Trajectories& trajectories) {
  events_ = &events;
  questions_ = &questions;
  robots_ = &robots;
  trajectories_ = &trajectories;
}

void OperatorService::request(const OperatorClient& client, const VerbRequest& request, Reply reply) {
  std::optional<config::Event> event;
  VerbReply answer = execute(client, request, event);
  answer.id = request.id;
  if (event)
    pending_.emplace(events_->give(*event), Pending{client, std::move(reply), request.id});
  else if (reply)
    reply(answer);
}

VerbReply OperatorService::execute(const OperatorClient& client, const VerbRequest& request,
                                   std::optional<config::Event>& event) {
  const std::string_view verb = request.verb->name;
  if (verb == "status") return report();
  if (verb == "echo") {
    if (!watched_of(request.argument("of")))
      return refuse(Refusal::invalid_argument, "of: " + config::in_quotes(request.argument("of")) + " is unknown",
                    "changes, robots, readings, world or all");
    return done("messages, questions and changes follow");
  }
  if (verb == "record") return record(client, std::string{request.argument("file")});
  if (verb == "command") return take_command(client);
  if (verb == "release") {
    if (!holder_.release(client))
      return not_now("this client does not hold command", holder_.free() ? "'command' before" : "");
    publish_holder();
    return done("command is free");
  }
  if (request.verb->commands && !holder_.allows(client))
    return refuse(Refusal::not_commander, holder_.name() + " holds command",
                  "'release' there, or the end of its connection");
  if (VerbReply refusal = check_phase(verb); !refusal.ok()) return refusal;
  if (phase() == TaskPhase::starting) {  // of the remaining verbs only `stop` and `estop` pass the check
    end_();
    return done("no robot has moved, the run ends");
  }
  if (verb == "answer") return give_answer(request, event);
  if (verb == "speed") return give_speed(request, event);
  if (verb == "follow" || verb == "cancel") return give_trajectory(request, event);
  if (config::is_robot_order(verb)) return give_order(request, event);
  event = config::Event{.command = std::string{verb}};
  return {};
}

VerbReply OperatorService::take_command(const OperatorClient& client) {
  if (holder_.held_by(client)) return done("this client holds command");
  if (!holder_.take(client)) {
    const std::string text = client.name + " asks for command, " + holder_.name() + " holds it";
    publish_(command_wanted_event(client.name, holder_.name()), text);
    return refuse(Refusal::not_commander, holder_.name() + " holds command and has received the request",
                  "'release' there, or the end of its connection");
  }
  publish_holder();
  return done("this client holds command until 'release' or the end of its connection");
}

VerbReply OperatorService::check_phase(std::string_view verb) const {
  const TaskPhase now = phase();
  if (verb == "estop") return {};
  if (now == TaskPhase::stopping) return not_now("the run ends", "a new run");
  if (verb == "stop") return {};
  if (now == TaskPhase::starting)
    return not_now("the processes are being started", "the state 'held' or 'running' of 'status'");
  if (verb == "start" && now != TaskPhase::held)
    return not_now("the task has started", "a run that waits for the start: mrroc run --hold");
  if (now == TaskPhase::held && (verb == "pause" || verb == "resume" || verb == "trigger"))
    return not_now("the task has not started", "'start' before");
  if (verb == "pause" && now == TaskPhase::paused) return not_now("the task is paused", "'resume'");
  if (verb == "resume" && now != TaskPhase::paused) return not_now("the task is not paused", "'pause' before");
  return {};
}

VerbReply OperatorService::give_answer(const VerbRequest& request, std::optional<config::Event>& event) {
  const std::string_view from = request.argument("from");
  const OpenQuestion* const question = questions_->find(from);
  if (question == nullptr) {
    std::string askers;
    for (const OpenQuestion& open : questions_->open()) askers += (askers.empty() ? "" : ", ") + open.asker;
    return not_now(from.empty() ? "no question is open" : std::string{from} + " has no open question",
                   askers.empty() ? "a question" : "from " + askers);
  }
  if (!may_answer())
    return not_now("under the clock 'lockstep' a live answer would come at another tick in every run",
                   "an event of the deployment that answers");
  std::string refusal;
  const auto value = process::read_answer(question->question, std::string{request.argument("value")}, refusal);
  if (!value) return refuse(Refusal::invalid_argument, refusal);
  event = config::Event{.command = "answer", .asker = question->asker, .value = *value, .question = question->number};
  questions_->close(question->asker);
  return {};
}

VerbReply OperatorService::give_speed(const VerbRequest& request, std::optional<config::Event>& event) {
  const std::string text{request.argument("value")};
  const std::optional<double> percent = core::to_finite(text);
  if (!percent || *percent < config::kLeastSpeedPercent || *percent > config::kFullSpeedPercent)
    return refuse(Refusal::invalid_argument, "value: " + config::in_quotes(text) + " is not a speed",
                  "percent from 1 to 100");
  event = config::Event{.command = "speed", .value = *percent};
  return {};
}

VerbReply OperatorService::give_order(const VerbRequest& request, std::optional<config::Event>& event) const {
  config::Event given{.command = std::string{request.verb->name}};
  config::RobotOrder& order = given.order;
  order.robot = request.argument("robot");
  order.axis = request.argument(request.verb->name == "output" ? "output" : "axis");
  order.posture = request.argument("posture");
  order.tool = request.argument("tool");
  order.frame = request.argument("in").empty() ? "axes" : request.argument("in");
  for (const char* name : {"velocity", "distance", "value"}) {
    const std::string text{request.argument(name)};
    if (text.empty()) continue;
    const std::optional<double> amount = core::to_finite(text);
    if (!amount)
      return refuse(Refusal::invalid_argument,
                    std::string{name} + ": " + config::in_quotes(text) + " " + core::number_problem(text), "a number");
    order.amount = *amount;
  }
  try {
    robots_->check(given.command, order);
  } catch (const std::invalid_argument& error) {
    return refuse(Refusal::invalid_argument, error.what());
  }
  VerbReply answered = check_answered(given);
  if (answered.ok()) event = given;
  return answered;
}

VerbReply OperatorService::check_answered(const config::Event& event) const {
  const auto ordered = ordered_.find(event.order.robot);
  if (ordered == ordered_.end() || event.command == "hold" || ordered->second.command == "jog") return {};
  return not_now(event.order.robot + " has not finished '" + ordered->second.command + "'",
                 "its end, or 'hold' before");
}

VerbReply OperatorService::report() const {
  VerbReply reply = done(std::string{"the task is "} + name_of(phase()));
  reply.data = to_json({.deployment = deployment_,
                        .phase = phase(),
                        .tick = events_ == nullptr ? 0 : events_->tick(),
                        .speed = events_ == nullptr ? 1 : events_->speed(),
                        .emergency_stopped = events_ != nullptr && events_->emergency_stopped(),
                        .commander = holder_.name(),
                        .processes = statuses_,
                        .questions = questions_,
                        .camera_files = camera_files_,
                        .yielded = trajectories_ == nullptr ? std::vector<std::string>{} : trajectories_->yielded()});
  return reply;
}

/// No command: a watcher may record, and the trace stays the same.
VerbReply OperatorService::record(const OperatorClient& client, const std::string& file) const try {
  if (!record_) return not_now("this run cannot record", "");
  VerbReply reply = done(record_(file));
  if (events_ != nullptr) reply.tick = events_->tick();
  const std::string text = "record by " + client.name + ": " + reply.text;
  publish_(message_event(text), client.number == 0 ? "" : text);
  return reply;
} catch (const std::logic_error& nothing) {
  return not_now(nothing.what(), "a task that has started, in a run without --black-box=");
} catch (const std::runtime_error& error) {
  return refuse(Refusal::invalid_argument, std::string{"file: "} + error.what(),
                "a new file in a folder that can be written");
}

void OperatorService::leave(const OperatorClient& client) {
  for (auto& [ticket, pending] : pending_)
    if (pending.client.number == client.number) pending.reply = nullptr;
  for (auto& [robot, ordered] : ordered_)
    if (ordered.pending.client.number == client.number) ordered.pending.reply = nullptr;
  for (auto& [number, followed] : followed_)
    if (followed.pending.client.number == client.number) followed.pending.reply = nullptr;
  for (auto& [pending, tick] : resets_)
    if (pending.client.number == client.number) pending.reply = nullptr;
  if (holder_.release(client)) publish_holder();
}

void OperatorService::poll() {
  if (events_ == nullptr) return;
  // first the answers: the orders that they belong to have then been performed
  std::vector<RobotOrders::Answer> answers;
  for (RobotOrders::Answer answer; robots_->take(answer);) answers.push_back(answer);
  const std::vector<TrajectoryReport> reports = trajectories_->take_reports();
  for (const OperatorEvents::Performed& performed : events_->take_performed()) {
    reply_to(performed);
    if (note_ && performed.refused.text == nullptr) note_(performed.event);
  }
  reply_to_resets();
  for (const RobotOrders::Answer& answer : answers) take_answer(answer);
  for (const TrajectoryReport& report : reports) take_report(report);
  const OpenQuestion* const first = questions_->find("");
  const std::string key = first == nullptr ? "" : first->asker + " " + std::to_string(first->number);
  if (key != published_question_ && first != nullptr) publish_(question_event(*first), "");
  published_question_ = key;
}

void OperatorService::update(const links::ProcessStatus& status) {
  links::ProcessStatus& known = statuses_[std::string{status.process.view()}];
  const bool other_error = known.error.code != status.error.code;
  const bool shown = other_error && status.error.code != ErrorCode::none && phase() == TaskPhase::held;
  const bool changed =
      known.process.empty() || known.state != status.state || known.instruction != status.instruction || other_error;
  known = status;
  if (!changed) return;
  const std::string event = process_event(status);
  publish_(event, shown ? event_text(event) : "");
}

void OperatorService::message(const std::string& line) { publish_(message_event(line), ""); }

void OperatorService::publish_holder() {
  publish_(commander_event(holder_.free() ? "" : holder_.name()),
           holder_.free() ? "command is free" : holder_.name() + " holds command");
}

}  // namespace mrroc::cli
