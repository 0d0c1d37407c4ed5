#include "links/telemetry/state_follower.hpp"

#include <utility>

#include "links/exchange/connect.hpp"
#include "links/transport/topic_name.hpp"

namespace mrroc::links {

StateFollower::StateFollower(Domain& domain, clock::Clock& clock, const std::string& prefix, const std::string& sensor,
                             std::string peer)
    : peer_(std::move(peer)),
      handshake_(domain, clock, topic_name(prefix, sensor + "/follow")),
      state_(domain, clock, topic_name(prefix, sensor + "/state"), {.depth = 64}) {}

void StateFollower::connect(double timeout) { links::connect(handshake_, {&state_}, timeout, peer_); }

}  // namespace mrroc::links
