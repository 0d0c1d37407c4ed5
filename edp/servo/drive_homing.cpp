#include "edp/servo/drive_homing.hpp"

namespace mrroc::edp {

DriveHoming::DriveHoming(const RobotParameters& robot) noexcept : count_(robot.axes.size()) {
  for (std::size_t i = 0; i < count_; ++i)
    order_[i] = robot.synchro_order.empty() ? static_cast<int>(i) : robot.synchro_order[i];
}

void DriveHoming::start(Hardware& hardware, const JointVector& shafts) noexcept {
  desired_ = DesiredState::resting_at(shafts);
  shift_ = JointVector::Zero(shafts.size());
  place_ = 0;
  hardware.home(axis());
}

DriveHoming::Status DriveHoming::step(Hardware& hardware, const HardwareInput& input, DesiredState& desired) noexcept {
  const int k = axis();
  desired_.position[k] = input.motors[k];
  desired = desired_;
  if (input.homing == Homing::failed) return Status::failed;
  if (input.homing != Homing::attained) return Status::running;
  shift_[k] = input.homing_shift;
  if (place_ + 1 == count_) return Status::done;
  ++place_;
  hardware.home(axis());
  return Status::running;
}

}  // namespace mrroc::edp
