#pragma once

#include <string>
#include <vector>

#include "links/transport/endpoint.hpp"

namespace mrroc::links {

/// The hand-shake of a link's requesting side, before the clock starts: pings every 20 ms until the responder's pong
/// has come on each of `from`, which proves that both directions carry messages. Discovery alone does not: one side may
/// know of the other while what it sends is still dropped. The responder answers on its own (`answer_through`). Blocks
/// for about `timeout` s at most. Throws SystemError: link_lost naming `peer` and the topic that is silent,
/// configuration when a peer's message types or settings do not match.
void connect(WriterBase& to, const std::vector<ReaderBase*>& from, double timeout, const std::string& peer);

}  // namespace mrroc::links
