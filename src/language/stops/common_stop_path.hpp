#pragma once

#include "geometry/desired_state.hpp"
#include "mrroc/common_stop.hpp"

namespace mrroc {

/// The joints of one robot during a CommonStop. Allocates nothing, never throws.
class CommonStopPath {
 public:
  /// `period`: servo period, s. `stop.ticks` above 0.
  void plan(const DesiredState& from, const CommonStop& stop, double period) noexcept;

  std::uint32_t ticks() const noexcept { return ticks_; }
  /// State t seconds after the start; from the end on exactly at rest.
  DesiredState at(double t) const noexcept;
  DesiredState end() const noexcept { return DesiredState::resting_at(position_at(duration_ * (1.0 / 3 + k_ / 12))); }

 private:
  JointVector position_at(double own) const noexcept {
    return from_.position + own * (from_.velocity + 0.5 * own * bend_);
  }

  DesiredState from_;
  JointVector bend_;  ///< a0 - rate v0
  double duration_ = 0, k_ = 2;
  std::uint32_t ticks_ = 0;
};

}  // namespace mrroc
