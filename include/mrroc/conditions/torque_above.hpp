#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <utility>

#include "mrroc/condition.hpp"
#include "mrroc/robot.hpp"
#include "mrroc/sensor.hpp"

namespace mrroc {

/// A sensor that measures a torque: `ForceTorque`, or one of yours.
template <class S>
concept TorqueSensor = std::derived_from<S, Sensor> && requires(const S& sensor) {
  { sensor.torque() } -> std::convertible_to<Eigen::Vector3d>;
};

/// The torque is larger than `newton_metres`, whatever its direction: |t| > newton_metres. Of a robot it is that of
/// `RobotState::wrench`, about the tool frame's origin (the robot needs `force_sensor` in the deployment); of a sensor
/// its own, about the sensor's origin. What is not known yet (NaN) is not above anything.
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
