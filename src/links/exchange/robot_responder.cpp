#include "links/exchange/robot_responder.hpp"

#include "links/exchange/robot_requester.hpp"
#include "links/transport/topic_name.hpp"

namespace mrroc::links {

RobotResponder::RobotResponder(Domain& domain, clock::Clock& clock, const std::string& prefix, double max_age)
    : exchange_(domain, clock, topic_name(prefix, "command"), topic_name(prefix, "state"), max_age) {}

bool RobotResponder::forward(RobotRequester& requester, std::uint64_t sequence) {
  return exchange_.forward(requester.exchange_, sequence);
}

}  // namespace mrroc::links
