#pragma once

#include <string>
#include <vector>

#include "links/transport/endpoint.hpp"

namespace mrroc::links {

/// The hand-shake of a link's requesting side, before the clock starts: pings every 20 ms until the responder's pong
/// has arrived on each of `from`, which proves that both directions carry messages. Discovery alone does not: one side
/// may have discovered the other while its messages are still dropped. The responder answers automatically
/// (`answer_through`). Blocks for about `timeout` s at most. Throws SystemError: link_lost with `peer` and the silent
/// topic, configuration when a peer's message types or settings do not match.
void connect(WriterBase& to, const std::vector<ReaderBase*>& from, double timeout, const std::string& peer);

}  // namespace mrroc::links
