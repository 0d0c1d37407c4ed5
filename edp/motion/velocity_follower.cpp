#include "edp/motion/velocity_follower.hpp"

#include "language/joints/axis_stop.hpp"

namespace mrroc::edp {

DesiredState follow_velocity(const RobotParameters& parameters, const DesiredState& from, const JointVector& velocity,
                             double dt) noexcept {
  DesiredState state = from;
  for (Eigen::Index i = 0; i < velocity.size(); ++i) {
    const AxisParameters& axis = parameters.axes[static_cast<std::size_t>(i)];
    AxisStop ramp;
    ramp.plan(from.position[i], from.velocity[i] - velocity[i], from.acceleration[i], axis.acceleration_max,
              axis.jerk_max);
    ramp.at(dt, state.position[i], state.velocity[i], state.acceleration[i]);
    state.position[i] += velocity[i] * dt;
    state.velocity[i] += velocity[i];
  }
  return state;
}

}  // namespace mrroc::edp
