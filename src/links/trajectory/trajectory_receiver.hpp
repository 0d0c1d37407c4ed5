#pragma once

#include <string>

#include "links/transport/reader.hpp"
#include "links/transport/writer.hpp"
#include "mrroc/trajectory_link.hpp"

namespace mrroc::links {

/// A task process's end of TrajectorySender's topics. The participant's thread.
class TrajectoryReceiver {
 public:
  /// `prefix`: "<deployment>/<process>".
  TrajectoryReceiver(Domain& domain, clock::Clock& clock, const std::string& prefix);

  /// Hand-shake with the operator's end, about `timeout` s at most; before the clock starts. Throws as links::connect.
  void connect(double timeout);
  /// The oldest part not yet taken. Neither waits, locks nor allocates.
  bool take(TrajectoryPart& part);
  /// Does not wait. Throws SystemError when DDS refuses it.
  void report(const TrajectoryReport& report) { writer_.write(report, ++reported_); }

 private:
  Writer<TrajectoryReport> writer_;
  Reader<TrajectoryPart> reader_;
  std::uint64_t reported_ = 0;
};

}  // namespace mrroc::links
