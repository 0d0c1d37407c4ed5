#include "mrroc/sensors/force_torque.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "mrroc/errors.hpp"

namespace mrroc {

namespace {

std::string condition_name(const ForceTorque& sensor, const char* what, double newtons) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " %s above %g N", what, newtons);
  return sensor.name() + text.data();
}

}  // namespace

ForceTorque::ForceTorque(Task& task, const std::string& name) : Sensor(task, name, "force_torque") {}

Wrench ForceTorque::wrench() const noexcept {
  Wrench wrench;
  wrench << force(), torque();
  return wrench;
}

Eigen::Vector3d ForceTorque::force() const noexcept { return {value(0), value(1), value(2)}; }

Eigen::Vector3d ForceTorque::torque() const noexcept { return {value(3), value(4), value(5)}; }

Wrench ForceTorque::in(const Pose& frame) const noexcept {
  const Eigen::Matrix3d to_frame = frame.linear().transpose();
  Wrench wrench;
  wrench << to_frame * force(), to_frame * (torque() - frame.translation().cross(force()));
  return wrench;
}

ForceAbove::ForceAbove(const ForceTorque& sensor, double newtons)
    : Condition(condition_name(sensor, "force", newtons)), sensor_(&sensor), newtons_(newtons) {
  if (!std::isfinite(newtons) || newtons < 0) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "ForceAbove " + std::to_string(newtons) + " N, expected a finite force of at least 0");
  }
}

bool ForceAbove::holds() { return sensor_->force().norm() > newtons_; }

ForceAlongAbove::ForceAlongAbove(const ForceTorque& sensor, const Eigen::Vector3d& direction, double newtons)
    : Condition(condition_name(sensor, "force along a direction", newtons)),
      sensor_(&sensor),
      direction_(direction.normalized()),
      newtons_(newtons) {
  if (!std::isfinite(newtons) || !direction.allFinite() || !(std::abs(direction_.norm() - 1) < 1e-9)) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "ForceAlongAbove needs a finite force and a finite direction that is not zero");
  }
}

bool ForceAlongAbove::holds() { return sensor_->force().dot(direction_) > newtons_; }

}  // namespace mrroc
