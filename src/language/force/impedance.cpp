#include "mrroc/generators/impedance.hpp"

#include <algorithm>

#include "core/require.hpp"
#include "geometry/rigid_motion.hpp"
#include "language/force/force_step.hpp"
#include "language/limits.hpp"
#include "mrroc/task.hpp"

namespace mrroc {

namespace {

void check(const ImpedanceParameters& parameters) {
  for (Eigen::Index i = 0; i < 6; ++i) {
    require_not_negative("Impedance", "stiffness", parameters.stiffness[i]);
    require_above_zero("Impedance", "damping", parameters.damping[i]);
    require_not_negative("Impedance", "inertia", parameters.inertia[i]);
  }
  require_above_zero("Impedance", "speed", parameters.speed);
  require_above_zero("Impedance", "angular speed", parameters.angular_speed);
  check_load("Impedance", parameters.load, parameters.gravity);
}

}  // namespace

Impedance::Impedance(Robot& robot, const Pose& pose, const ImpedanceParameters& parameters)
    : Impedance(
          robot,
          [pose](double) {
            MovingFrame frame;
            frame.pose = pose;
            return frame;
          },
          parameters) {
  if (!is_rigid(pose)) throw NonFatalError(ErrorCode::invalid_argument, "Impedance: the pose is not rigid");
}

Impedance::Impedance(Robot& robot, SetPoint set_point, const ImpedanceParameters& parameters)
    : Generator("Impedance"), robot_(&robot), set_point_(std::move(set_point)), parameters_(parameters) {
  if (!set_point_) throw NonFatalError(ErrorCode::invalid_argument, "Impedance without a function for the set-point");
  check(parameters);
}

void Impedance::start() {
  elapsed_ = 0;
  resume();
}

void Impedance::resume() {
  first_ = true;
  spring_.setZero();
  const double step = robot_->step_duration();
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double stiffest = kStiffest * parameters_.damping[i] / step;
    if (parameters_.stiffness[i] <= stiffest) continue;
    throw NonFatalError(ErrorCode::invalid_argument,
                        "Impedance: stiffness " + number_text(parameters_.stiffness[i], stiffest) + " of tool axis " +
                            std::to_string(i + 1) + " with a damping of " + std::to_string(parameters_.damping[i]) +
                            " in steps of " + std::to_string(step) + " s, expected at most " +
                            number_text(stiffest, parameters_.stiffness[i]),
                        {robot_->task().process_name(), robot_->name(), 0, robot_->state().tick});
  }
}

void Impedance::next_state() {
  const double step = robot_->step_duration();
  const ToolPrediction tool = predict_tool(*robot_, first_, 0.5 * step);
  const MovingFrame wanted = set_point_(elapsed_ + 0.5 * step);
  const Eigen::Matrix3d to_tool = tool.pose.linear().transpose();
  Twist error;
  error << to_tool * (wanted.pose.translation() - tool.pose.translation()),
      rotation_vector(to_tool * wanted.pose.linear());
  if (!error.allFinite() || !wanted.twist.allFinite())
    throw NonFatalError(ErrorCode::not_finite, "set-point of the impedance of " + robot_->name());
  spring_ = parameters_.stiffness.cwiseProduct(error);

  const Wrench pull = spring_ + parameters_.damping.cwiseProduct(rotate_twist(to_tool, wanted.twist));
  const Wrench weight = weight_of(parameters_.load, robot_->state().pose.linear(), parameters_.gravity);
  const Twist free = (pull + robot_->state().wrench - weight).cwiseQuotient(parameters_.damping);
  ForceLaw::Axes damping = parameters_.damping;
  damping.head<3>() *= std::max(1.0, free.head<3>().norm() / parameters_.speed);
  damping.tail<3>() *= std::max(1.0, free.tail<3>().norm() / parameters_.angular_speed);

  RobotCommand& command = robot_->command();
  command.kind = CommandKind::force;
  for (int i = 0; i < 6; ++i) command.force.contact(i, weight[i] - pull[i]);
  command.force.inertia = parameters_.inertia;
  command.force.admittance = damping.cwiseInverse();
  elapsed_ += step;
  first_ = false;
}

}  // namespace mrroc
