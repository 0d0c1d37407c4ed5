#include "links/exchange/task_subordinate.hpp"

#include <string>
#include <utility>

#include "links/transport/topic_name.hpp"
#include "mrroc/errors.hpp"

namespace mrroc::links {

TaskSubordinate::TaskSubordinate(Domain& domain, clock::Clock& clock, const std::string& prefix)
    : writer_(domain, clock, topic_name(prefix, "task_status")),
      reader_(domain, clock, topic_name(prefix, "task_command"), {.depth = kDepth, .answer_through = {&writer_}}) {}

bool TaskSubordinate::take(TaskCommand& command) {
  const bool taken = reader_.take(command, taken_);
  if (const std::uint64_t lost = reader_.counters().overwritten; lost != std::exchange(lost_, lost))
    throw NonFatalError(ErrorCode::busy, "more than " + std::to_string(kDepth) +
                                             " commands and messages have come before the task took them: " +
                                             std::to_string(lost) + " are lost");
  return taken;
}

void TaskSubordinate::report(const TaskStatus& status) { writer_.write(status, taken_.sequence, taken_.boot); }

}  // namespace mrroc::links
