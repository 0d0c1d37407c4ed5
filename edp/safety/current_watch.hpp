#pragma once

#include <array>
#include <cmath>

#include "mrroc/robot_parameters.hpp"

namespace mrroc::edp {

/// Watches the measured currents: none may stay at its axis's current_max or beyond for longer than current_max_time.
/// A drive at its limit moves against too large a load; a current that is safe for a moment overheats it later. The
/// servo's thread; allocates nothing, never throws.
class CurrentWatch {
 public:
  /// `parameters` must outlive this object; `period` in s.
  CurrentWatch(const RobotParameters& parameters, double period) noexcept : parameters_(&parameters), period_(period) {}

  /// The drives have been switched on.
  void reset() noexcept { ticks_.fill(0); }
  /// Takes the currents (A) measured after another `ticks` ticks. Returns the first axis that has been at its limit for
  /// too long, or -1.
  int check(const JointVector& current, double ticks) noexcept {
    int beyond = -1;
    for (std::size_t i = parameters_->axes.size(); i-- > 0;) {
      const AxisParameters& axis = parameters_->axes[i];
      const bool at_limit = !(std::abs(current[static_cast<Eigen::Index>(i)]) < axis.current_max);
      ticks_[i] = at_limit ? ticks_[i] + ticks : 0;
      if (ticks_[i] * period_ > axis.current_max_time) beyond = static_cast<int>(i);
    }
    return beyond;
  }

 private:
  const RobotParameters* parameters_;
  double period_;
  std::array<double, kMaxJoints> ticks_{};  ///< at the limit without a break
};

}  // namespace mrroc::edp
