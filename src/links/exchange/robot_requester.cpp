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
  const bool long_one = !answered_ || command.kind == CommandKind::synchronise || command.kind == CommandKind::recover;
  const Tick now = clock_.tick() + (long_one ? kLongest : 0);
  if (command.kind == CommandKind::query) return now;
  if (command.start_tick > now + kLongest) return now;  // refused at once
  return command.reply_tick(busy_until_, now);
}

void RobotRequester::send(const RobotCommand& command, Tick timeout) {
  exchange_.send(command, due(command) + timeout);
}

void RobotRequester::forward(RobotResponder& responder, const RobotCommand& command) {
  exchange_.forward(responder.exchange_, due(command) + timeout_);
}

void RobotRequester::receive(RobotState& state) {
  exchange_.receive(state);
  answered_ = true;
  busy_until_ = state.desired_tick;
}

}  // namespace mrroc::links
