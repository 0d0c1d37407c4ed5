#include "links/exchange/robot_requester.hpp"

#include <algorithm>

#include "links/transport/topic_name.hpp"

namespace mrroc::links {

RobotRequester::RobotRequester(Domain& domain, clock::Clock& clock, const std::string& prefix, std::string peer,
                               Tick timeout)
    : clock_(clock),
      timeout_(timeout),
      exchange_(domain, clock, topic_name(prefix, "command"), topic_name(prefix, "state"), std::move(peer)) {}

void RobotRequester::send(const RobotCommand& command, Tick timeout) {
  Tick due = clock_.tick();
  if (command.kind == CommandKind::synchronise) due += kSynchronisation;
  if (command.kind != CommandKind::query) due = std::max({due, command.start_tick, busy_until_}) + command.reply_step;
  exchange_.send(command, due + timeout);
}

void RobotRequester::receive(RobotState& state) {
  exchange_.receive(state);
  busy_until_ = state.desired_tick;
}

}  // namespace mrroc::links
