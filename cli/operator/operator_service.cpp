#include "cli/operator/operator_service.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "cli/operator/operator_state.hpp"
#include "process/answer_text.hpp"

namespace mrroc::cli {

namespace {

VerbReply done(std::string text) {
  VerbReply reply;
  reply.text = std::move(text);
  return reply;
}

VerbReply refuse(Refusal refusal, std::string text, std::string expected = "") {
  VerbReply reply;
  reply.refusal = refusal;
  reply.text = std::move(text);
  reply.expected = std::move(expected);
  return reply;
}

VerbReply not_now(std::string text, std::string expected) {
  return refuse(Refusal::not_allowed, std::move(text), std::move(expected));
}

std::string line_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

OperatorService::OperatorService(const config::Deployment& deployment) : deployment_(deployment) {}

void OperatorService::connect(OperatorEvents& events, Questions& questions) {
  events_ = &events;
  questions_ = &questions;
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
  if (verb == "echo") return done("messages, questions and changes follow");
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
  if (const VerbReply refusal = check_phase(verb); !refusal.ok()) return refusal;
  if (phase() == TaskPhase::starting) {  // of the remaining verbs only `stop` and `estop` pass the check
    end_();
    return done("no robot has moved, the run ends");
  }
  if (verb == "answer") return give_answer(request, event);
  event = config::Event{0, std::string{verb}, "", 0, 0};
  return {};
}

VerbReply OperatorService::take_command(const OperatorClient& client) {
  if (holder_.held_by(client)) return done("this client holds command");
  if (!holder_.take(client)) {
    const std::string text = client.name + " asks for command, " + holder_.name() + " holds it";
    publish_(line_of({{"event", "command_wanted"}, {"by", client.name}, {"commander", holder_.name()}}), text);
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
  event = config::Event{0, "answer", question->asker, *value, question->number};
  questions_->close(question->asker);
  return {};
}

VerbReply OperatorService::report() const {
  VerbReply reply = done(std::string{"the task is "} + name_of(phase()));
  reply.data = to_json({.deployment = deployment_,
                        .phase = phase(),
                        .tick = events_ == nullptr ? 0 : events_->tick(),
                        .emergency_stopped = events_ != nullptr && events_->emergency_stopped(),
                        .commander = holder_.name(),
                        .processes = statuses_,
                        .questions = questions_});
  return reply;
}

void OperatorService::leave(const OperatorClient& client) {
  for (auto& [ticket, pending] : pending_)
    if (pending.client.number == client.number) pending.reply = nullptr;
  if (holder_.release(client)) publish_holder();
}

void OperatorService::poll() {
  if (events_ == nullptr) return;
  for (const OperatorEvents::Performed& performed : events_->take_performed()) {
    reply_to(performed);
    if (note_) note_(performed.event);
  }
  const OpenQuestion* const first = questions_->find("");
  const std::string key = first == nullptr ? "" : first->asker + " " + std::to_string(first->number);
  if (key != published_question_ && first != nullptr) publish_(question_event(*first), "");
  published_question_ = key;
}

void OperatorService::reply_to(const OperatorEvents::Performed& performed) {
  const auto pending = pending_.find(performed.ticket);
  const std::string by = pending == pending_.end() ? "an event of the deployment" : pending->second.client.name;
  const bool shown = pending == pending_.end() || pending->second.client.number == 0;
  publish_(line_of({{"event", "command"},
                    {"command", performed.event.command},
                    {"by", by},
                    {"tick", performed.event.tick},
                    {"task", name_of(phase())}}),
           shown ? "" : performed.event.command + " by " + by + " at tick " + std::to_string(performed.event.tick));
  if (pending == pending_.end()) return;
  VerbReply reply = done(std::string{find_verb(performed.event.command)->effect});
  reply.tick = performed.event.tick;
  reply.id = pending->second.id;
  if (pending->second.reply) pending->second.reply(reply);
  pending_.erase(pending);
}

void OperatorService::end(int exit_code, const std::string& reason) {
  for (auto& [ticket, pending] : std::exchange(pending_, {})) {
    VerbReply reply = refuse(Refusal::ended, "the run has ended before the next tick");
    reply.id = pending.id;
    if (pending.reply) pending.reply(reply);
  }
  publish_(line_of({{"event", "end"}, {"exit_code", exit_code}, {"reason", reason}}), "");
}

void OperatorService::update(const links::ProcessStatus& status) {
  links::ProcessStatus& known = statuses_[std::string{status.process.view()}];
  const bool changed = known.process.empty() || known.state != status.state ||
                       known.instruction != status.instruction || known.error.code != status.error.code;
  known = status;
  if (changed) publish_(process_event(status), "");
}

void OperatorService::message(const std::string& line) { publish_(message_event(line), ""); }

void OperatorService::publish_holder() {
  publish_(line_of({{"event", "commander"},
                    {"commander", holder_.free() ? nullptr : nlohmann::ordered_json(holder_.name())}}),
           holder_.free() ? "command is free" : holder_.name() + " holds command");
}

}  // namespace mrroc::cli
