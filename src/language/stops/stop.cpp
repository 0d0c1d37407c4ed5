#include "language/stops/stop.hpp"

#include <algorithm>
#include <cmath>

#include "mrroc/errors.hpp"

namespace mrroc {

Stop::Stop(const RobotParameters& parameters, double period)
    : count_(static_cast<int>(parameters.axes.size())), period_(period) {
  for (const AxisParameters& axis : parameters.axes) {
    if (!(axis.acceleration_max > 0) || !(axis.jerk_max > 0))
      throw SystemError(ErrorCode::configuration,
                        "axis " + axis.name + ": acceleration_max and jerk_max must be above 0 for the robot to stop");
  }
  use(parameters);
}

void Stop::use(const RobotParameters& parameters) noexcept {
  for (std::size_t i = 0; i < parameters.axes.size(); ++i)
    limits_[i] = {parameters.axes[i].acceleration_max, parameters.axes[i].jerk_max};
}

void Stop::plan(const DesiredState& from) noexcept {
  double longest = 0;
  for (int i = 0; i < count_; ++i) {
    const auto k = static_cast<std::size_t>(i);
    axes_[k].plan(from.position[i], from.velocity[i], from.acceleration[i], limits_[k].acceleration, limits_[k].jerk);
    longest = std::max(longest, axes_[k].duration());
  }
  ticks_ = static_cast<std::uint32_t>(std::ceil(longest / period_));
}

DesiredState Stop::at(double t) const noexcept {
  DesiredState state{JointVector(count_), JointVector(count_), JointVector(count_)};
  for (int i = 0; i < count_; ++i) axis(i).at(t, state.position[i], state.velocity[i], state.acceleration[i]);
  return state;
}

DesiredState Stop::end() const noexcept {
  DesiredState state = DesiredState::resting_at(JointVector::Zero(count_));
  for (int i = 0; i < count_; ++i) state.position[i] = axis(i).end_position();
  return state;
}

}  // namespace mrroc
