#pragma once

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "links/wire/task_messages.hpp"

namespace mrroc::links {

/// The commanding end of a task link, operator to MP or MP to ECP: topics `<prefix>/task_command` and
/// `<prefix>/task_status`. One thread.
class TaskSuperior {
 public:
  /// `prefix`: "<deployment>/<process>"; `peer`: the subordinate's name, for errors.
  TaskSuperior(Domain& domain, clock::Clock& clock, const std::string& prefix, std::string peer);

  /// Hand-shake with the subordinate, about `timeout` s at most; before the clock starts. Throws as links::connect.
  void connect(double timeout);

  /// Sends a command and returns its number (1, 2, ...). Does not wait. Throws SystemError when DDS refuses it.
  std::uint64_t send(TaskCommandKind kind, const Message& parcel = {});
  /// The same of TaskCommandKind::speed.
  std::uint64_t send_speed(double speed);

  /// The oldest status not yet taken; `last_command` is the number of the last command that the subordinate had taken
  /// when it reported, so that a status sent before a command can be recognised. Neither waits, locks nor allocates.
  bool take(TaskStatus& status, std::uint64_t& last_command);

  /// Any thread.
  bool peer_alive() const noexcept { return reader_.peer_alive(); }
  ReaderCounters counters() const noexcept { return reader_.counters(); }

 private:
  const std::string peer_;
  const std::uint64_t boot_;
  Writer<TaskCommand> writer_;
  Reader<TaskStatus> reader_;
  std::uint64_t sequence_ = 0;
};

}  // namespace mrroc::links
