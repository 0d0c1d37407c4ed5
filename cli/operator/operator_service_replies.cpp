// The operator's service: replies to requests whose effect comes later, at a tick or with a robot's answer.
#include <string>
#include <utility>

#include "cli/operator/operator_service.hpp"
#include "cli/operator/operator_state.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::cli {

/// The robot answers the newest order only.
void OperatorService::order_given(const OperatorEvents::Performed& performed, Pending pending) {
  const std::string& robot = performed.event.order.robot;
  if (const auto earlier = ordered_.find(robot); earlier != ordered_.end()) {
    VerbReply reply = not_now("ended by '" + performed.event.command + "'", "");
    if (earlier->second.command == "jog") reply = done(std::string{find_verb("jog")->effect});
    reply.id = earlier->second.pending.id;
    if (earlier->second.pending.reply) earlier->second.pending.reply(reply);
  }
  ordered_[robot] = {performed.number, performed.event.command, std::move(pending)};
}

void OperatorService::take_answer(const RobotOrders::Answer& answer) {
  const auto ordered = ordered_.find(answer.robot);
  if (ordered == ordered_.end() || ordered->second.number != answer.number) return;
  const ErrorReport& error = answer.state.error;
  VerbReply reply = error.error_class == ErrorClass::none
                        ? done(std::string{find_verb(ordered->second.command)->effect})
                        : not_now(answer.robot + ": " + std::string{describe(error.code)} +
                                      (error.detail.empty() ? "" : ": " + std::string{error.detail.view()}),
                                  "");
  reply.tick = answer.state.tick;
  reply.id = ordered->second.pending.id;
  if (ordered->second.pending.reply) ordered->second.pending.reply(reply);
  ordered_.erase(ordered);
}

/// No client waits for an event of the deployment: the watchers see its refusal.
void OperatorService::report_refused(const OperatorEvents::Performed& performed) {
  const auto pending = pending_.find(performed.ticket);
  const std::string& robot = performed.event.order.robot;
  const std::string why = (robot.empty() ? "" : robot + ": ") + performed.refused.text;
  if (pending == pending_.end()) {
    const std::string text = performed.event.command + " by an event of the deployment at tick " +
                             std::to_string(performed.event.tick) + " is refused: " + why;
    publish_(message_event(text), text);
    return;
  }
  VerbReply reply = not_now(why, performed.refused.expected);
  reply.id = pending->second.id;
  if (pending->second.reply) pending->second.reply(reply);
  pending_.erase(pending);
}

void OperatorService::reply_to(const OperatorEvents::Performed& performed) {
  if (performed.refused.text != nullptr) {
    report_refused(performed);
    return;
  }
  const auto pending = pending_.find(performed.ticket);
  const std::string by = pending == pending_.end() ? "an event of the deployment" : pending->second.client.name;
  const bool repeated = performed.event.command == "jog";  // many times a second
  const bool shown = repeated || pending == pending_.end() || pending->second.client.number == 0;
  publish_(command_event(performed.event, by, phase()),
           shown ? "" : performed.event.command + " by " + by + " at tick " + std::to_string(performed.event.tick));
  if (pending == pending_.end()) return;
  if (performed.event.command == "follow") {
    followed_.emplace(performed.number, Followed{performed.event.order.robot, std::move(pending->second)});
    pending_.erase(pending);
    return;
  }
  if (performed.number != 0) {
    order_given(performed, std::move(pending->second));
    pending_.erase(pending);
    return;
  }
  if (performed.event.command == "reset") {
    resets_.emplace_back(std::move(pending->second), performed.event.tick);
    pending_.erase(pending);
    return;
  }
  VerbReply reply = done(std::string{find_verb(performed.event.command)->effect});
  reply.tick = performed.event.tick;
  reply.id = pending->second.id;
  if (pending->second.reply) pending->second.reply(reply);
  pending_.erase(pending);
}

/// Orders to robots are refused before the reset has arrived at every host.
void OperatorService::reply_to_resets() {
  if (resets_.empty() || !events_->emergency_stop_arrived()) return;
  for (const auto& [pending, tick] : std::exchange(resets_, {})) {
    VerbReply reply = done(std::string{find_verb("reset")->effect});
    reply.tick = tick;
    reply.id = pending.id;
    if (pending.reply) pending.reply(reply);
  }
}

void OperatorService::end(int exit_code, const std::string& reason) {
  const auto refuse_pending = [](const Pending& pending) {
    VerbReply reply = refuse(Refusal::ended, "the run has ended before the command");
    reply.id = pending.id;
    if (pending.reply) pending.reply(reply);
  };
  for (const auto& [ticket, pending] : std::exchange(pending_, {})) refuse_pending(pending);
  for (const auto& [pending, tick] : std::exchange(resets_, {})) refuse_pending(pending);
  for (const auto& [robot, ordered] : std::exchange(ordered_, {})) refuse_pending(ordered.pending);
  for (const auto& [number, followed] : std::exchange(followed_, {})) refuse_pending(followed.pending);
  publish_(end_event(exit_code, reason), "");
}

}  // namespace mrroc::cli
