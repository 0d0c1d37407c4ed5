#include "cli/run/watch/heartbeats.hpp"

#include <algorithm>
#include <utility>

namespace mrroc::cli {

std::vector<std::string> Heartbeats::missing(const std::vector<std::string>& processes) const {
  std::vector<std::string> names;
  for (const std::string& process : processes)
    if (!statuses_.contains(process)) names.push_back(process);
  return names;
}

void Heartbeats::expect(const std::vector<std::string>& processes, double now) {
  const double heard = watched(now);
  for (const std::string& process : processes) heard_[process] = heard;
}

bool Heartbeats::take(const links::ProcessStatus& status, double now) {
  const std::string name{status.process.view()};
  const auto known = statuses_.find(name);
  if (known != statuses_.end() && known->second.beat == status.beat) return false;
  statuses_[name] = status;
  if (const auto heard = heard_.find(name); heard != heard_.end()) heard->second = watched(now);
  return true;
}

std::string Heartbeats::silent(double now) {
  const double present = watched(now);
  for (const auto& [name, heard] : heard_)
    if (present - heard > timeout_) return name;
  return "";
}

double Heartbeats::watched(double now) {
  watched_ += std::min(now - std::exchange(last_call_, now), kLongestPause);
  return watched_;
}

}  // namespace mrroc::cli
