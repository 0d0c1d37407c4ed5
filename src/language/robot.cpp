#include "mrroc/robot.hpp"

#include "mrroc/task.hpp"

namespace mrroc {

Robot::Robot(Task& task, const std::string& name, RobotModels models)
    : task_(&task),
      name_(task.robot_name(name)),
      models_(std::move(models)),
      link_(&task.robot_link(name_, parameters().type)) {}

ToolKinematics Robot::kinematics() const noexcept {
  const bool known = state_.desired_joints.size() != 0 && state_.model < models_.size();
  return known ? ToolKinematics(*models_[state_.model], state_.tool) : ToolKinematics(*models_.front());
}

void Robot::set_macrostep(std::uint16_t motion_steps, std::uint16_t reply_step) {
  if (motion_steps < 1 || motion_steps > kMaxMotionSteps) {
    throw NonFatalError(ErrorCode::invalid_motion_steps,
                        "N = " + std::to_string(motion_steps) + ", expected 1 to " + std::to_string(kMaxMotionSteps),
                        {task_->process_name(), name_, 0, 0});
  }
  if (reply_step < 1 || reply_step > motion_steps + 1) {
    throw NonFatalError(
        ErrorCode::invalid_reply_step,
        "v = " + std::to_string(reply_step) + ", expected 1 to N + 1 = " + std::to_string(motion_steps + 1),
        {task_->process_name(), name_, 0, 0});
  }
  motion_steps_ = motion_steps;
  reply_step_ = reply_step;
}

const RobotState& Robot::known_state() const {
  const auto axes = static_cast<Eigen::Index>(parameters().axes.size());
  if (state_.desired_joints.size() != axes || state_.desired_velocity.size() != axes ||
      state_.desired_acceleration.size() != axes) {
    throw NonFatalError(ErrorCode::invalid_argument,
                        "the state of this robot is not known, expected it in the list of the Move",
                        {task_->process_name(), name_, 0, 0});
  }
  return state_;
}

double Robot::step_duration() const noexcept { return motion_steps_ * task_->servo_period(); }

void Robot::reset_command(CommandKind kind) noexcept {
  command_.kind = kind;
  command_.relative = false;
  command_.motion_steps = motion_steps_;
  command_.reply_step = reply_step_;
  command_.start_tick = 0;
  command_.joints.resize(0);
  command_.joint_velocity.resize(0);
  command_.joint_acceleration.resize(0);
  command_.pose.setIdentity();
  command_.twist.setZero();
}

}  // namespace mrroc
