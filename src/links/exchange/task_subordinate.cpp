#include "links/exchange/task_subordinate.hpp"

#include "links/transport/topic_name.hpp"

namespace mrroc::links {

TaskSubordinate::TaskSubordinate(Domain& domain, clock::Clock& clock, const std::string& prefix)
    : writer_(domain, clock, topic_name(prefix, "task_status")),
      reader_(domain, clock, topic_name(prefix, "task_command"), {.answer_through = {&writer_}}) {}

bool TaskSubordinate::take(TaskCommand& command) { return reader_.take(command, taken_); }

void TaskSubordinate::report(const TaskStatus& status) { writer_.write(status, taken_.sequence, taken_.boot); }

}  // namespace mrroc::links
