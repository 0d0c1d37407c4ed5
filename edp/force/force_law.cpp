#include "edp/force/force_law.hpp"

#include <cmath>

#include "edp/safety/error_report.hpp"

namespace mrroc::edp {

ErrorReport check_force_law(const ForceLaw& law, const Twist& velocity) noexcept {
  for (int i = 0; i < 6; ++i) {
    const double inertia = law.inertia[i], damping = law.admittance[i];
    const AxisBehaviour behaviour = law.behaviour[static_cast<std::size_t>(i)];
    if (!std::isfinite(velocity[i]) || !std::isfinite(law.wrench[i]))
      return make_report(ErrorClass::non_fatal, ErrorCode::not_finite,
                         "force motion, tool axis %d: velocity %g, force %g", i + 1, velocity[i], law.wrench[i]);
    if (!(inertia >= 0) || !std::isfinite(inertia))
      return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                         "force motion, tool axis %d: inertia %g, expected a finite number of at least 0", i + 1,
                         inertia);
    if (!(damping >= 0) || !std::isfinite(damping) || (damping == 0 && behaviour == AxisBehaviour::contact))
      return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument,
                         "force motion, tool axis %d: admittance %g, expected a finite number %s 0", i + 1, damping,
                         behaviour == AxisBehaviour::contact ? "above" : "of at least");
    if (behaviour > AxisBehaviour::contact)
      return make_report(ErrorClass::non_fatal, ErrorCode::invalid_argument, "force motion, tool axis %d: behaviour %d",
                         i + 1, static_cast<int>(behaviour));
  }
  return {};
}

Twist follow_force(const ForceLaw& law, const Twist& velocity, const Wrench& measured, const Twist& previous,
                   double dt) noexcept {
  Twist twist;
  for (int i = 0; i < 6; ++i) {
    const AxisBehaviour behaviour = law.behaviour[static_cast<std::size_t>(i)];
    if (behaviour == AxisBehaviour::unguarded) {
      twist[i] = velocity[i];
      continue;
    }
    const bool contact = behaviour == AxisBehaviour::contact;
    const double desired = contact ? law.wrench[i] : 0;
    const double commanded = contact ? 0 : velocity[i];
    const double lag = law.admittance[i] * law.inertia[i];  // s
    twist[i] = ((law.admittance[i] * (measured[i] - desired) + commanded) * dt + lag * previous[i]) / (dt + lag);
  }
  return twist;
}

Wrench seen_from(const Pose& frame, const Wrench& wrench) noexcept {
  const Eigen::Vector3d force = wrench.head<3>();
  const Eigen::Vector3d torque = wrench.tail<3>() - frame.translation().cross(force);
  Wrench result;
  result << frame.linear().transpose() * force, frame.linear().transpose() * torque;
  return result;
}

}  // namespace mrroc::edp
