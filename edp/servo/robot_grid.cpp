#include "edp/servo/robot_grid.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::edp {

double RobotGrid::place(const Beat& beat) noexcept {
  const double elapsed = beat.time - time_;
  const double offset = static_cast<double>(beat.received - epoch_) * 1e-9 - beat.time;
  const bool continues = started_ && elapsed >= 0 && elapsed < kRestart;
  started_ = true;
  time_ = beat.time;
  offset_ = continues ? std::min(offset, offset_ + kDrift * elapsed) : offset;
  const double exact = (beat.time + offset_) / period_;
  const double steps = elapsed / period_;
  const double ahead = exact - (place_ + steps);
  if (continues && std::abs(ahead) <= kFarthest)
    place_ += steps + std::clamp(ahead, -kSlew * steps, kSlew * steps);
  else
    place_ = exact;
  return place_;
}

}  // namespace mrroc::edp
