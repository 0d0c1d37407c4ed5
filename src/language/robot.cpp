#include "mrroc/robot.hpp"

#include "kinematics/loaded_model.hpp"
#include "kinematics/measured_model.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

Robot::Robot(Task& task, const std::string& name, const std::string& type,
             RobotModels (*load)(const std::filesystem::path&))
    : Robot(task, name, load(task.robot_parameters(task.robot_name(name), type))) {}

Robot::Robot(Task& task, const std::string& name, RobotModels models)
    : task_(&task),
      name_(task.robot_name(name)),
      models_(kinematics::with_measured(kinematics::with_load(std::move(models), task.robot_load(name_)),
                                        task.measured_arm(name_))),
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

void Robot::acquire() {
  if (in_use_)
    throw NonFatalError(ErrorCode::busy, "another fiber moves this robot", {task_->process_name(), name_, 0, 0});
  in_use_ = true;
}

double Robot::step_duration() const noexcept { return motion_steps_ * task_->servo_period(); }

void Robot::set_tool(const Pose& tool) {
  reset_command(CommandKind::set_tool);
  command_.pose = tool;
  change();
}

void Robot::use_model(std::string_view name) {
  std::vector<std::string_view> names;
  for (const auto& model : models_) names.push_back(model->name());
  choose(CommandKind::use_model, "model", name, names);
}

void Robot::use_regulators(std::string_view name) {
  std::vector<std::string_view> names;
  for (const RegulatorSet& set : parameters().regulators) names.push_back(set.name);
  choose(CommandKind::use_regulators, "regulators", name, names);
}

void Robot::choose(CommandKind kind, const char* what, std::string_view name,
                   const std::vector<std::string_view>& names) {
  std::string known;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) {
      reset_command(kind);
      command_.choice = static_cast<std::uint8_t>(i);
      return change();
    }
    known.append(i == 0 ? "" : ", ").append(names[i]);
  }
  throw NonFatalError(ErrorCode::invalid_argument,
                      std::string(what) + " '" + std::string(name) + "', expected one of: " + known,
                      {task_->process_name(), name_, 0, 0});
}

void Robot::set_outputs(const ControllerIo& outputs) {
  reset_command(CommandKind::set_outputs);
  command_.outputs = outputs;
  change();
}

void Robot::synchronise() {
  reset_command(CommandKind::synchronise);
  change();
}

void Robot::recover() {
  reset_command(CommandKind::recover);
  change();
}

void Robot::bias_force() {
  reset_command(CommandKind::bias_force);
  change();
}

void Robot::carry(const Load& load) {
  reset_command(CommandKind::carry);
  command_.load = load;
  change();
}

void Robot::change() {
  send();
  receive();
  const ErrorReport& error = state_.error;
  if (error.error_class == ErrorClass::none) return;
  throw_error(error.error_class, error.code, std::string{error.detail.view()},
              {task_->process_name(), name_, 0, state_.tick});
}

void Robot::reset_command(CommandKind kind) noexcept {
  command_.kind = kind;
  command_.relative = false;
  command_.interpolation = Interpolation::joints;
  command_.motion_steps = motion_steps_;
  command_.reply_step = reply_step_;
  command_.start_tick = 0;
  command_.joints.resize(0);
  command_.joint_velocity.resize(0);
  command_.joint_acceleration.resize(0);
  command_.pose.setIdentity();
  command_.twist.setZero();
  command_.twist_acceleration.resize(0);
  command_.force = ForceLaw{};
  command_.stop = CommonStop{};
  command_.load = Load{};
  command_.choice = 0;
  command_.with_outputs = false;
  command_.outputs = ControllerIo{};
}

}  // namespace mrroc
