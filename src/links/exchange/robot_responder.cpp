#include "links/exchange/robot_responder.hpp"

#include "links/transport/topic_name.hpp"

namespace mrroc::links {

RobotResponder::RobotResponder(Domain& domain, clock::Clock& clock, const std::string& prefix, double max_age)
    : exchange_(domain, clock, topic_name(prefix, "command"), topic_name(prefix, "state"), max_age) {}

}  // namespace mrroc::links
