#include "links/exchange/robot_operator.hpp"

#include <utility>

#include "links/exchange/connect.hpp"
#include "links/transport/topic_name.hpp"

namespace mrroc::links {

RobotOperator::RobotOperator(Domain& domain, clock::Clock& clock, const std::string& prefix, std::string peer)
    : peer_(std::move(peer)),
      boot_(domain.boot()),
      writer_(domain, clock, topic_name(prefix, "command")),
      reader_(domain, clock, topic_name(prefix, "state"), {.depth = 16}) {}

void RobotOperator::connect(double timeout) { links::connect(writer_, {&reader_}, timeout, peer_); }

std::uint64_t RobotOperator::send(const RobotCommand& command) {
  writer_.write(command, ++sent_);
  return sent_;
}

bool RobotOperator::take(RobotState& state, std::uint64_t& number) {
  Header header;
  while (reader_.take(state, header)) {
    if (header.answers != boot_) continue;
    number = header.sequence;
    return true;
  }
  return false;
}

}  // namespace mrroc::links
