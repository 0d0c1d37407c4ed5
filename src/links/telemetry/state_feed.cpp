#include "links/telemetry/state_feed.hpp"

#include "links/transport/topic_name.hpp"

namespace mrroc::links {

StateFeed::StateFeed(Domain& domain, clock::Clock& clock, const std::string& prefix, const std::string& sensor)
    : state_(domain, clock, topic_name(prefix, sensor + "/state")),
      handshake_(domain, clock, topic_name(prefix, sensor + "/follow"), {.answer_through = {&state_}}) {}

}  // namespace mrroc::links
