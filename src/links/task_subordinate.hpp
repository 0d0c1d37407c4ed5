#pragma once

#include "links/reader.hpp"
#include "links/task_messages.hpp"
#include "links/writer.hpp"

namespace mrroc::links {

/// The commanded end of a task link, in the MP or an ECP; it answers the superior's hand-shake by itself. One thread.
class TaskSubordinate {
 public:
  TaskSubordinate(Domain& domain, clock::Clock& clock, const std::string& prefix);

  /// The oldest command not yet taken. Neither waits, locks nor allocates.
  bool take(TaskCommand& command);
  /// Tells the superior, who sees which command was the last taken. Throws SystemError when DDS refuses it.
  void report(const TaskStatus& status);

  /// Any thread.
  bool peer_alive() const noexcept { return reader_.peer_alive(); }
  ReaderCounters counters() const noexcept { return reader_.counters(); }

 private:
  Writer<TaskStatus> writer_;
  Reader<TaskCommand> reader_;
  Header taken_;
};

}  // namespace mrroc::links
