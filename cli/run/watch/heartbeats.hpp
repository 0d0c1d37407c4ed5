#pragma once

#include <map>
#include <string>
#include <vector>

#include "links/wire/process_status.hpp"

namespace mrroc::cli {

/// The last status of every process of a run, and its arrival. All times `now` are s of wall time, and do not decrease.
/// Time in which the runner itself did not look, because the machine was busy or stood still, is not the processes'
/// silence: between two calls at most kLongestPause counts. Main thread.
class Heartbeats {
 public:
  static constexpr double kLongestPause = 0.25;  ///< s

  /// `timeout`: s without a sign of life after which a process counts as silent.
  explicit Heartbeats(double timeout) : timeout_(timeout) {}

  /// The processes without a status so far.
  std::vector<std::string> missing(const std::vector<std::string>& processes) const;
  /// From now on each of them must send heartbeats.
  void expect(const std::vector<std::string>& processes, double now);
  /// Takes a status; returns false when it repeats the last one.
  bool take(const links::ProcessStatus& status, double now);
  const std::map<std::string, links::ProcessStatus>& statuses() const noexcept { return statuses_; }
  /// The first silent process; empty when none is silent.
  std::string silent(double now);

 private:
  /// s in which the runner has looked, up to `now`.
  double watched(double now);

  double timeout_;
  double last_call_ = 0, watched_ = 0;
  std::map<std::string, links::ProcessStatus> statuses_;
  std::map<std::string, double> heard_;  ///< in watched time
};

}  // namespace mrroc::cli
