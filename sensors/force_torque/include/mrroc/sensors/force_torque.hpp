#pragma once

#include <string>

#include "mrroc/condition.hpp"
#include "mrroc/sensor.hpp"
#include "mrroc/types.hpp"

namespace mrroc {

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
