#include "cli/stall_watch.hpp"

#include <cmath>

namespace mrroc::cli {

std::string StallWatch::look(double now) {
  const std::uint64_t delta = clock_.delta();
  const Tick tick = clock_.tick();
  if (delta != delta_ || tick != tick_ || !clock_.waits_for_somebody()) {
    delta_ = delta;
    tick_ = tick;
    since_ = now;
    patience_ = kPatience;
  }
  if (now - since_ < patience_) return "";
  patience_ *= 2;
  return "nothing has happened for " + std::to_string(std::lround(now - since_)) + " s; clock " + clock_.describe();
}

}  // namespace mrroc::cli
