#include "links/exchange/robot_requester.hpp"

#include <algorithm>

#include "links/transport/topic_name.hpp"

namespace mrroc::links {

RobotRequester::RobotRequester(Domain& domain, clock::Clock& clock, const std::string& prefix, std::string peer,
                               Tick timeout)
    : clock_(clock),
      timeout_(timeout),
      exchange_(domain, clock, topic_name(prefix, "command"), topic_name(prefix, "state"), std::move(peer)) {}

Tick RobotRequester::due(const RobotCommand& command) const {
  const Tick now = clock_.tick() + (command.kind == CommandKind::synchronise ? kSynchronisation : 0);
  return command.kind == CommandKind::query ? now : command.reply_tick(busy_until_, now);
}

void RobotRequester::send(const RobotCommand& command, Tick timeout) {
  exchange_.send(command, due(command) + timeout);
}

void RobotRequester::forward(RobotResponder& responder, const RobotCommand& command) {
  exchange_.forward(responder.exchange_, due(command) + timeout_);
}

void RobotRequester::receive(RobotState& state) {
  exchange_.receive(state);
  busy_until_ = state.desired_tick;
}

}  // namespace mrroc::links
