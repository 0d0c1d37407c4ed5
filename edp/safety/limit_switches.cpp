#include "edp/safety/limit_switches.hpp"

#include <cmath>

namespace mrroc::edp {
namespace {

constexpr double kRest = 1e-9;  // rad: rounding of a set-point at rest

}  // namespace

/// True: the axis has come onto the switch, or is on it and moves on `towards` it.
bool LimitSwitchWatch::check(Known& known, bool on, double motor, double towards, double leave) const noexcept {
  if (on && !known.is) {
    known = {true, motor};
    return true;
  }
  if (!on && known.is && std::abs(motor - known.at) > leave) known.is = false;
  return on && towards > kRest;
}

int LimitSwitchWatch::check(const HardwareInput& input, const JointVector& increment, int finding) noexcept {
  int stopped = -1;
  on_ = {};
  for (std::size_t i = parameters_->axes.size(); i-- > 0;) {
    const auto k = static_cast<Eigen::Index>(i);
    const AxisSwitches& switches = input.switches[i];
    const double leave = parameters_->axes[i].following_error_max;
    const bool lower = check(lower_[i], switches.lower_limit, input.motors[k], -increment[k], leave);
    const bool upper = check(upper_[i], switches.upper_limit, input.motors[k], increment[k], leave);
    if (switches.lower_limit) on_.lower = static_cast<std::uint16_t>(on_.lower | 1u << i);
    if (switches.upper_limit) on_.upper = static_cast<std::uint16_t>(on_.upper | 1u << i);
    if ((lower || upper) && finding != kEvery && finding != static_cast<int>(i)) stopped = static_cast<int>(i);
  }
  return stopped;
}

}  // namespace mrroc::edp
