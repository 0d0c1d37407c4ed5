#include "sim/errors/faulty_transmission.hpp"

#include <algorithm>
#include <cmath>

namespace mrroc::sim {

FaultyTransmission::FaultyTransmission(const config::ErrorsEntry& errors, const std::string& robot,
                                       const RobotParameters& parameters)
    : noise_(errors.seed, robot, "current_noise"), current_noise_(errors.current_noise) {
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    const AxisParameters& axis = parameters.axes[i];
    axes_.push_back({errors_of_joint(errors, robot, axis.name), axis.torque_constant * axis.current_max,
                     axis.rotor_inertia, axis.torque_max});
    position_[i] = parameters.home[static_cast<Eigen::Index>(i)];
  }
}

void FaultyTransmission::report(world::JointMeasurement& measurement) noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const TrueJoint& truth = axes_[i].truth;
    const double q = measurement.position[i];
    if (measured_) play_[i] = std::clamp(play_[i] + q - position_[i], -truth.backlash / 2, truth.backlash / 2);
    position_[i] = q;
    const double slope = truth.slope(q);
    measurement.position[i] = truth.reported(q) + play_[i];
    measurement.velocity[i] *= slope;
    measurement.torque[i] /= slope;
  }
  measured_ = true;
}

void FaultyTransmission::act(world::JointDrive& drive, Tick tick) const noexcept {
  const bool follows_current = drive.kind == world::JointDrive::Kind::torque;
  std::array<double, kMaxJoints> slopes{};
  for (std::size_t i = 0; i < axes_.size(); ++i) slopes[i] = axes_[i].truth.slope(position_[i]);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (follows_current && current_noise_ > 0) {
      const double limit = torque_limit(axes_[i], drive.rotor_inertia[i * kMaxJoints + i]);
      drive.torque[i] += noise_.normal(current_noise_ * limit, tick, static_cast<std::uint32_t>(i));
    }
    drive.torque[i] *= slopes[i];
    drive.bias[i] *= slopes[i];
    drive.torque_max[i] *= slopes[i];
    drive.velocity[i] /= slopes[i];
    if (!follows_current) drive.position[i] = axes_[i].truth.joint(drive.position[i] - play_[i]);
  }
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    for (std::size_t j = 0; j < axes_.size(); ++j) {
      const double product = slopes[i] * slopes[j];
      drive.rotor_inertia[i * kMaxJoints + j] *= product;
      drive.damping[i * kMaxJoints + j] *= product;
    }
  }
}

std::array<double, kMaxJoints> FaultyTransmission::friction(const world::JointDrive& drive) const noexcept {
  std::array<double, kMaxJoints> friction{};
  for (std::size_t i = 0; i < axes_.size(); ++i)
    friction[i] = axes_[i].truth.friction * torque_limit(axes_[i], drive.rotor_inertia[i * kMaxJoints + i]);
  return friction;
}

/// 0 when neither is known: the axis then has no friction and no noise.
double FaultyTransmission::torque_limit(const Axis& axis, double reflected_inertia) const noexcept {
  if (std::isfinite(axis.torque_max)) return axis.torque_max;
  return axis.rotor_inertia > 0 ? axis.current_torque * std::sqrt(reflected_inertia / axis.rotor_inertia) : 0;
}

}  // namespace mrroc::sim
