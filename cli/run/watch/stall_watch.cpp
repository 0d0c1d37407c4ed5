#include "cli/run/watch/stall_watch.hpp"

#include <cmath>

namespace mrroc::cli {

double StallWatch::Stall::check(std::uint64_t present, double now) {
  if (present != mark) *this = {present, now, kPatience};
  if (now - since < patience) return 0;
  patience *= 2;
  return now - since;
}

std::string StallWatch::check(double now) {
  const std::string line = check_simulated_time(now);
  return line.empty() ? check_processes(now) : line;
}

std::string StallWatch::check_simulated_time(double now) {
  if (!clock_.waits_for_somebody()) {
    time_ = {0, now, kPatience};
    return "";
  }
  const double stall = time_.check(clock_.delta() + clock_.tick() + 1, now);  // both only increase
  if (stall == 0) return "";
  return "nothing has happened for " + std::to_string(std::lround(stall)) + " s; clock " + clock_.describe();
}

std::string StallWatch::check_processes(double now) {
  std::string line;
  for (const auto& [name, waits] : clock_.at_work()) {
    const double stall = processes_[name].check(waits, now);
    if (stall == 0) continue;
    line += line.empty() ? "" : "; ";
    line += name + " has waited for nothing for " + std::to_string(std::lround(stall)) +
            " s: it computes, or is blocked outside of MRROC++";
  }
  return line;
}

}  // namespace mrroc::cli
