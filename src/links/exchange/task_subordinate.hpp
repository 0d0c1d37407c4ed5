#pragma once

#include <cstdint>

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "links/wire/task_messages.hpp"

namespace mrroc::links {

/// The commanded end of a task link, in the MP or an ECP; it answers the superior's hand-shake automatically. One
/// thread.
class TaskSubordinate {
 public:
  /// Commands and messages that may wait; more than a mailbox holds.
  static constexpr std::size_t kDepth = 64;

  TaskSubordinate(Domain& domain, clock::Clock& clock, const std::string& prefix);

  /// The oldest command not yet taken. Neither waits, locks nor allocates. Throws NonFatalError(busy) when commands are
  /// lost, because more than kDepth have come since the last look.
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
  std::uint64_t lost_ = 0;
};

}  // namespace mrroc::links
