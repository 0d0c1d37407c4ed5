#pragma once

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "links/wire/task_messages.hpp"

namespace mrroc::links {

/// The commanded end of a task link, in the MP or an ECP; it answers the superior's hand-shake automatically. One
/// thread.
class TaskSubordinate {
 public:
  TaskSubordinate(Domain& domain, clock::Clock& clock, const std::string& prefix);

  /// The oldest command not yet taken. Neither waits, locks nor allocates.
  bool take(TaskCommand& command);
  /// Reports to the superior, with the number of the command taken last. Throws SystemError when DDS refuses it.
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
