#pragma once

#include <map>
#include <string>
#include <vector>

#include "links/wire/process_status.hpp"

namespace mrroc::cli {

/// The last word of every process of a run, and when it was heard, s of wall time. Main thread.
class Heartbeats {
 public:
  /// `timeout`: s without a sign of life after which a process counts as silent.
  explicit Heartbeats(double timeout) : timeout_(timeout) {}

  /// Those of which no status has come yet.
  std::vector<std::string> missing(const std::vector<std::string>& processes) const;
  /// From now on each of them is expected to beat.
  void expect(const std::vector<std::string>& processes, double now);
  /// Takes a status; false when it is the last one again.
  bool take(const links::ProcessStatus& status, double now);
  const std::map<std::string, links::ProcessStatus>& statuses() const noexcept { return statuses_; }
  /// The first that is silent; empty: none.
  std::string silent(double now) const;

 private:
  double timeout_;
  std::map<std::string, links::ProcessStatus> statuses_;
  std::map<std::string, double> heard_;
};

}  // namespace mrroc::cli
