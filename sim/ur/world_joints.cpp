#include "sim/ur/world_joints.hpp"

#include <numbers>
#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::sim::ur {

namespace {

[[noreturn]] void refuse(const RobotParameters& robot, const std::string& problem) {
  throw SystemError(ErrorCode::configuration, std::string("robot ").append(robot.type).append(problem));
}

}  // namespace

WorldJoints::WorldJoints(const RobotParameters& robot, world::WorldMemory& memory, std::size_t slot)
    : robot_(robot), memory_(memory), slot_(slot) {
  if (robot.axes.size() != position_.size())
    refuse(robot, " has " + std::to_string(robot.axes.size()) + " axes, expected 6 behind a UR controller");
  if (robot.drives.bandwidth <= 0) refuse(robot, " has no bandwidth of its drives, expected a number above 0 Hz");
  measure();
}

void WorldJoints::measure() {
  world::JointMeasurement measurement;
  if (!memory_.measurements[slot_].load(measurement)) return;
  tick_ = measurement.tick;
  for (std::size_t i = 0; i < position_.size(); ++i) {
    position_[i] = measurement.position[i];
    velocity_[i] = measurement.velocity[i];
  }
  inputs_ = measurement.inputs;
  world::FlangeMeasurement flange;
  if (!memory_.flanges[slot_].load(flange)) return;
  flange_.pose.translation() = Eigen::Map<const Eigen::Vector3d>(flange.position.data());
  flange_.pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(flange.rotation.data());
  flange_.load = Eigen::Map<const Wrench>(flange.load.data());
}

void WorldJoints::step(const JointTargets& targets, double period) {
  measure();
  world::JointDrive drive;
  drive.tick = tick_;
  drive.outputs = outputs_;
  drive.joint_count = static_cast<std::uint32_t>(position_.size());
  drive.enabled = targets.kind == JointTargets::Kind::brake ? 0 : 1;
  drive.bandwidth = 2 * std::numbers::pi * robot_.drives.bandwidth;
  const bool positions = targets.kind == JointTargets::Kind::position;
  const bool continues = positions && last_.kind == JointTargets::Kind::position;
  drive.kind = positions ? world::JointDrive::Kind::position : world::JointDrive::Kind::velocity;
  for (std::size_t i = 0; i < position_.size(); ++i) {
    drive.position[i] = targets.position[i];
    drive.velocity[i] = positions ? 0 : targets.velocity[i];
    if (continues) drive.velocity[i] = (targets.position[i] - last_.position[i]) / period;
    drive.torque_max[i] = robot_.axes[i].torque_max;
  }
  last_ = targets;
  memory_.drives[slot_].store(drive);
  memory_.driven.open();
}

}  // namespace mrroc::sim::ur
