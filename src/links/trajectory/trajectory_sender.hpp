#pragma once

#include <string>

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "mrroc/trajectory_link.hpp"

namespace mrroc::links {

/// The operator's end of the way on which trajectories come to a task process: topics `<prefix>/trajectory` and
/// `<prefix>/trajectory_report`. It answers the process's hand-shake by itself. `send` and `take` may be called by two
/// threads, each by one at a time.
class TrajectorySender {
 public:
  /// `prefix`: "<deployment>/<process>".
  TrajectorySender(Domain& domain, clock::Clock& clock, const std::string& prefix);

  /// Does not wait. Throws SystemError when DDS refuses it.
  void send(const TrajectoryPart& part) { writer_.write(part, ++sent_); }
  /// The oldest report not yet taken. Neither waits, locks nor allocates.
  bool take(TrajectoryReport& report);

 private:
  Writer<TrajectoryPart> writer_;
  Reader<TrajectoryReport> reader_;
  std::uint64_t sent_ = 0;
};

}  // namespace mrroc::links
