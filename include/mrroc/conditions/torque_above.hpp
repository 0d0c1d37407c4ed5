#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <utility>

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// A sensor that measures a torque: `ForceTorque` or a user-defined class.
template <class S>
concept TorqueSensor = std::derived_from<S, Sensor> && requires(const S& sensor) {
  { sensor.torque() } -> std::convertible_to<Eigen::Vector3d>;
};

/// The torque is larger than `newton_metres` in any direction: |t| > newton_metres. For a robot it is the torque of
/// `RobotState::wrench`, about the tool frame's origin (the robot needs `force_sensor` in the deployment); for a sensor
/// it is the measured torque, about the sensor's origin. A torque that is not known yet (NaN) does not satisfy the
/// condition.
class TorqueAbove : public Condition {
 public:
  /// Throw NonFatalError(invalid_argument) unless `newton_metres` is finite and not negative.
  TorqueAbove(const Robot& robot, double newton_metres);
  template <TorqueSensor S>
  TorqueAbove(const S& sensor, double newton_metres)
      : TorqueAbove(
            sensor.name(), [&sensor] { return Eigen::Vector3d{sensor.torque()}; }, newton_metres) {}

 protected:
  bool holds() override { return torque_().norm() > newton_metres_; }

 private:
  TorqueAbove(const std::string& name, std::function<Eigen::Vector3d()> torque, double newton_metres);

  std::function<Eigen::Vector3d()> torque_;
  double newton_metres_;
};

}  // namespace mrroc
