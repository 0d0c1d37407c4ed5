#pragma once

#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/sensor.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

/// Configuration of a force/torque sensor: the load that its tool carries besides the tool's own mass (the deployment's
/// `tool_mass`), kg, and its centre of gravity in the sensor frame, m. Its weight is then no part of the reading. Mass
/// 0: the tool is empty. Refused where the sensor does not follow the pose of its robot (keys `robot`, `tool_mass`).
/// `Robot::carry` lets the robot's own force law and force limits learn it.
struct Carrying {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};
MRROC_MESSAGE(Carrying, mass, centre)

/// Configuration of a force/torque sensor: the cut-off of its low-pass, Hz, 0 (none) to half the servo rate, in place
/// of the deployment's `cutoff`. The filter begins with the next hardware reading.
struct LowPassAt {
  double cutoff = 0;
};
MRROC_MESSAGE(LowPassAt, cutoff)

/// A force/torque sensor of the deployment, type `force_torque`. Its reading is the wrench that the environment exerts
/// on the tool, in the axes of the sensor frame and about its origin, after bias: a tool whose z axis points down and
/// which presses on a table has force().z() < 0. NaN before the first reading. Task's thread.
class ForceTorque : public Sensor {
 public:
  /// Throws NonFatalError when the deployment has no such sensor.
  ForceTorque(Task& task, const std::string& name);

  Wrench wrench() const noexcept;           ///< N, N m
  Eigen::Vector3d force() const noexcept;   ///< N
  Eigen::Vector3d torque() const noexcept;  ///< N m
  /// The same wrench in another frame that is fixed to the sensor frame: in its axes, about its origin. With `frame` =
  /// (R, p), its orientation and position in the sensor frame (m),
  ///
  ///     force' = R^T force        torque' = R^T (torque - p x force)
  ///
  /// `frame` is taken as rigid.
  Wrench in(const Pose& frame) const noexcept;
};

/// The force is larger than `newtons`, in any direction: |f| > newtons.
class ForceAbove : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless `newtons` is finite and at least 0.
  ForceAbove(const ForceTorque& sensor, double newtons);

 protected:
  bool holds() override;

 private:
  const ForceTorque* sensor_;
  double newtons_;
};

/// The force along a direction of the sensor frame is larger than `newtons`: f . d / |d| > newtons. The environment's
/// force: pressing along +z is ForceAlongAbove{wrist, {0, 0, -1}, 10}.
class ForceAlongAbove : public Condition {
 public:
  /// Throws NonFatalError(invalid_argument) unless all values are finite and `direction` is not zero.
  ForceAlongAbove(const ForceTorque& sensor, const Eigen::Vector3d& direction, double newtons);

 protected:
  bool holds() override;

 private:
  const ForceTorque* sensor_;
  Eigen::Vector3d direction_;  ///< of length 1
  double newtons_;
};

}  // namespace mrroc
