#include "links/exchange/task_superior.hpp"

#include "links/exchange/connect.hpp"
#include "links/transport/topic_name.hpp"

namespace mrroc::links {

TaskSuperior::TaskSuperior(Domain& domain, clock::Clock& clock, const std::string& prefix, std::string peer)
    : peer_(std::move(peer)),
      boot_(domain.boot()),
      writer_(domain, clock, topic_name(prefix, "task_command")),
      reader_(domain, clock, topic_name(prefix, "task_status"), {.depth = 64}) {}

void TaskSuperior::connect(double timeout) { links::connect(writer_, {&reader_}, timeout, peer_); }

std::uint64_t TaskSuperior::send(TaskCommandKind kind, const Message& parcel) {
  writer_.write({kind, parcel}, ++sequence_);
  return sequence_;
}

std::uint64_t TaskSuperior::send_speed(double speed) {
  writer_.write({TaskCommandKind::speed, {}, speed}, ++sequence_);
  return sequence_;
}

bool TaskSuperior::take(TaskStatus& status, std::uint64_t& last_command) {
  Header header;
  if (!reader_.take(status, header)) return false;
  last_command = header.answers == boot_ ? header.sequence : 0;
  return true;
}

}  // namespace mrroc::links
