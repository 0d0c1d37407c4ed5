#include "language/macrostep/macrostep_path.hpp"

#include "geometry/rigid_motion.hpp"

namespace mrroc {

void MacrostepPath::plan_joints(const DesiredState& from, const DesiredState& to, double duration) noexcept {
  space_ = Space::joints;
  quintic_.plan(from, to, duration);
}

ErrorCode MacrostepPath::plan_motors(const RobotModel& model, const DesiredState& from, const DesiredState& to,
                                     double duration, double period) noexcept {
  space_ = Space::motors;
  model_ = &model;
  difference_ = kDifference * period;
  DesiredState shafts[2];
  const DesiredState* joints[2] = {&from, &to};
  for (int end = 0; end < 2; ++end) {
    const DesiredState& state = *joints[end];
    if (const ErrorCode code = model.joints_to_motors(state.position, shafts[end].position); code != ErrorCode::none)
      return code;
    const JointMatrix ratio = model.transmission(state.position);
    const JointVector step = state.velocity * difference_;
    const JointMatrix change = model.transmission(state.position + step) - model.transmission(state.position - step);
    shafts[end].velocity = ratio * state.velocity;
    shafts[end].acceleration = ratio * state.acceleration + change * state.velocity / (2 * difference_);
  }
  quintic_.plan(shafts[0], shafts[1], duration);
  return ErrorCode::none;
}

ErrorCode MacrostepPath::plan_task(const ToolKinematics& kinematics, const DesiredState& from, const MovingPose& to,
                                   double duration, double period) noexcept {
  space_ = Space::task;
  model_ = &kinematics.model();
  inverse_tool_ = kinematics.tool().inverse();
  difference_ = kDifference * period;
  const MovingPose start = tool_motion(kinematics, from, difference_);
  rotation_ = start.pose.linear();
  const DesiredState end = coordinates(to);
  if (!(end.position.tail<3>().norm() <= kTurnMax)) return ErrorCode::invalid_argument;
  quintic_.plan(coordinates(start), end, duration);
  return ErrorCode::none;
}

void MacrostepPath::plan_velocity(const RobotParameters& parameters, const DesiredState& from,
                                  const JointVector& velocity) noexcept {
  space_ = Space::velocity;
  velocity_ = velocity;
  for (std::size_t i = 0; i < parameters.axes.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    ramps_[i].plan(from.position[k], from.velocity[k] - velocity[k], from.acceleration[k],
                   parameters.axes[i].acceleration_max, parameters.axes[i].jerk_max);
  }
}

Eigen::Matrix<double, 6, 1> MacrostepPath::coordinates(const Pose& pose) const noexcept {
  Eigen::Matrix<double, 6, 1> x;
  x << pose.translation(), rotation_vector(rotation_.transpose() * pose.linear());
  return x;
}

DesiredState MacrostepPath::coordinates(const MovingPose& tool) const noexcept {
  const Eigen::Matrix<double, 6, 1> now = coordinates(tool.pose);
  DesiredState state = DesiredState::resting_at(now);
  if (tool.twist.isZero(0) && tool.rate.isZero(0)) return state;
  const Eigen::Matrix<double, 6, 1> before = coordinates(tool.after(-difference_));
  const Eigen::Matrix<double, 6, 1> after = coordinates(tool.after(difference_));
  state.velocity = (after - before) / (2 * difference_);
  state.acceleration = (after - 2 * now + before) / (difference_ * difference_);
  return state;
}

ErrorCode MacrostepPath::joints_at(double t, const JointVector& near, JointVector& joints) const noexcept {
  const JointVector x = quintic_.at(t).position;
  if (space_ == Space::motors) return model_->motors_to_joints(x, joints);
  Pose tool = Pose::Identity();
  tool.translation() = x.head<3>();
  tool.linear() = rotation_ * exp_rotation(x.tail<3>());
  return model_->inverse(tool * inverse_tool_, near, joints);
}

ErrorCode MacrostepPath::at(double t, const JointVector& near, DesiredState& state) const noexcept {
  if (space_ == Space::joints) {
    state = quintic_.at(t);
    return ErrorCode::none;
  }
  if (space_ == Space::velocity) {
    const Eigen::Index count = velocity_.size();
    state = DesiredState{JointVector(count), JointVector(count), JointVector(count)};
    for (Eigen::Index i = 0; i < count; ++i)
      ramps_[static_cast<std::size_t>(i)].at(t, state.position[i], state.velocity[i], state.acceleration[i]);
    state.position += velocity_ * t;
    state.velocity += velocity_;
    return ErrorCode::none;
  }
  JointVector before, after;
  if (const ErrorCode code = joints_at(t, near, state.position); code != ErrorCode::none) return code;
  if (const ErrorCode code = joints_at(t - difference_, state.position, before); code != ErrorCode::none) return code;
  if (const ErrorCode code = joints_at(t + difference_, state.position, after); code != ErrorCode::none) return code;
  state.velocity = (after - before) / (2 * difference_);
  state.acceleration = (after - 2 * state.position + before) / (difference_ * difference_);
  return ErrorCode::none;
}

}  // namespace mrroc
