#include "drivers/mujoco/mujoco_hardware.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mrroc::edp {

namespace {

constexpr double kDifferenceTime = 1e-4;  // s: far above rounding, short enough to neglect the transmission's curvature

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

}  // namespace

MujocoHardware::MujocoHardware(const RobotModel& model, world::WorldMemory& memory, std::size_t slot, Timing timing,
                               bool synchronised, double patience)
    : model_(model),
      drives_(model.parameters().drives),
      memory_(memory),
      slot_(slot),
      timing_(timing),
      patience_ns_(std::llround(patience * 1e9)),
      encoders_(model.parameters(), synchronised) {
  const int count = model.joint_count();
  joints_ = model.parameters().home;
  velocity_ = current_ = shafts_ = set_position_ = set_velocity_ = JointVector::Zero(count);
}

/// Takes the measurement of tick `tick`. In real time it waits for it, and gets a later one where the world has
/// continued without this robot.
bool MujocoHardware::await(Tick tick, world::JointMeasurement& measurement) noexcept {
  const auto& slot = memory_.measurements[slot_];
  if (timing_ == Timing::newest) return slot.load(measurement);
  if (timing_ == Timing::lockstep) return slot.load(measurement) && measurement.tick == tick;
  const auto reached = [&] { return slot.load(measurement) && measurement.tick >= tick; };
  if (reached()) return true;
  if (silent_ && measurement.tick == silent_since_) return false;
  silent_ = !memory_.measured.wait(reached, patience_ns_);
  silent_since_ = measurement.tick;
  return !silent_;
}

void MujocoHardware::read(Tick tick, HardwareInput& input) noexcept {
  world::JointMeasurement measurement;
  input.fault = await(tick, measurement) ? ErrorCode::none : ErrorCode::hardware_silent;
  if (input.fault == ErrorCode::none) {
    input.time = static_cast<double>(measurement.tick);
    input.inputs = measurement.inputs;
    for (Eigen::Index i = 0; i < joints_.size(); ++i) {
      joints_[i] = measurement.position[static_cast<std::size_t>(i)];
      velocity_[i] = measurement.velocity[static_cast<std::size_t>(i)];
    }
    if (drives_.regulate_themselves()) measure_torques(measurement);
    JointVector shafts;
    if (model_.joints_to_motors(joints_, shafts) == ErrorCode::none)
      shafts_ = shafts;
    else
      input.fault = ErrorCode::drive_fault;
  }
  encoders_.read(shafts_, input);
  input.current = current_;
}

/// i = G^-T tau / k_t.
void MujocoHardware::measure_torques(const world::JointMeasurement& measurement) noexcept {
  JointVector torque(joints_.size());
  for (Eigen::Index i = 0; i < torque.size(); ++i) torque[i] = measurement.torque[static_cast<std::size_t>(i)];
  const JointMatrix ratio = model_.transmission(joints_).inverse();
  current_ = ratio.transpose() * torque;
  for (std::size_t i = 0; i < model_.parameters().axes.size(); ++i)
    current_[index(i)] /= model_.parameters().axes[i].torque_constant;
}

void MujocoHardware::set_points(const JointVector& position, const JointVector& velocity) noexcept {
  set_position_ = encoders_.shafts(position);
  set_velocity_ = velocity;
}

void MujocoHardware::write(Tick tick, const JointVector& current) noexcept {
  world::JointDrive drive{};
  drive.tick = tick;
  drive.joint_count = static_cast<std::uint32_t>(joints_.size());
  drive.enabled = enabled_ ? 1 : 0;
  drive.outputs = outputs_;
  if (drives_.regulate_themselves())
    write_set_points(drive);
  else
    write_currents(current, drive);
  memory_.drives[slot_].store(drive);
  if (timing_ != Timing::lockstep) memory_.driven.open();
}

void MujocoHardware::write_currents(const JointVector& current, world::JointDrive& drive) noexcept {
  const auto& axes = model_.parameters().axes;
  const Eigen::Index count = joints_.size();
  JointVector torque(count), inertia(count), friction(count);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double limit = axes[i].current_max;
    current_[index(i)] = enabled_ ? std::clamp(current[index(i)], -limit, limit) : 0.0;
    torque[index(i)] = axes[i].torque_constant * current_[index(i)];
    inertia[index(i)] = axes[i].rotor_inertia;
    friction[index(i)] = axes[i].viscous_friction;
  }
  const JointMatrix g = model_.transmission(joints_);
  const JointVector step = velocity_ * kDifferenceTime;
  const JointMatrix difference = model_.transmission(joints_ + step) - model_.transmission(joints_ - step);
  const JointMatrix b = g.transpose() * inertia.asDiagonal() * g;
  const JointMatrix d = g.transpose() * friction.asDiagonal() * g;
  const JointVector tau = g.transpose() * torque;
  const JointVector shaft_acceleration = difference * velocity_ / (2 * kDifferenceTime);
  const JointVector c = g.transpose() * inertia.cwiseProduct(shaft_acceleration);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto row = static_cast<std::size_t>(i);
    drive.torque[row] = tau[i];
    drive.bias[row] = c[i];
    for (Eigen::Index j = 0; j < count; ++j) {
      const std::size_t entry = row * kMaxJoints + static_cast<std::size_t>(j);
      drive.rotor_inertia[entry] = b(i, j);
      drive.damping[entry] = d(i, j);
    }
  }
}

void MujocoHardware::write_set_points(world::JointDrive& drive) const noexcept {
  const bool velocities = drives_.interface == DriveParameters::Interface::velocity;
  drive.kind = velocities ? world::JointDrive::Kind::velocity : world::JointDrive::Kind::position;
  drive.bandwidth = 2 * std::numbers::pi * drives_.bandwidth;
  JointVector position = joints_;
  // a set-point beyond the transmission's reach holds the robot where it is; the servo has seen it, too
  const bool reached = model_.motors_to_joints(set_position_, position) == ErrorCode::none;
  JointVector velocity = JointVector::Zero(joints_.size());
  if (reached) velocity = model_.transmission(position).inverse() * set_velocity_;
  if (velocities && reached) velocity += drives_.position_gain * (position - joints_);
  for (Eigen::Index i = 0; i < joints_.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    drive.position[row] = position[i];
    drive.velocity[row] = velocity[i];
    drive.torque_max[row] = model_.parameters().axes[row].torque_max;
  }
}

}  // namespace mrroc::edp
