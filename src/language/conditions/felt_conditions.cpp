// Conditions on the measured wrench: TorqueAbove, TouchingAlong.
#include <cmath>

#include "core/require.hpp"
#include "core/short_number.hpp"
#include "mrroc/conditions/torque_above.hpp"
#include "mrroc/conditions/touching_along.hpp"

namespace mrroc {

TorqueAbove::TorqueAbove(const Robot& robot, double newton_metres)
    : TorqueAbove(
          robot.name(), [&robot] { return Eigen::Vector3d{robot.state().wrench.tail<3>()}; }, newton_metres) {}

TorqueAbove::TorqueAbove(const std::string& name, std::function<Eigen::Vector3d()> torque, double newton_metres)
    : Condition(name + " torque above " + short_number(newton_metres) + " N m"),
      torque_(std::move(torque)),
      newton_metres_(newton_metres) {
  require_not_negative("TorqueAbove", "torque", newton_metres);
}

TouchingAlong::TouchingAlong(const Robot& robot, const Eigen::Vector3d& direction, double newtons)
    : Condition(robot.name() + " presses with " + short_number(newtons) + " N"),
      robot_(&robot),
      direction_(direction.normalized()),
      newtons_(newtons) {
  require_above_zero("TouchingAlong", "force", newtons);
  if (!direction.allFinite() || !(std::abs(direction_.norm() - 1) < 1e-9))
    throw NonFatalError(ErrorCode::invalid_argument, "TouchingAlong needs a finite direction that is not zero");
}

}  // namespace mrroc
