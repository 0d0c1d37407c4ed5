#include "mrroc/generators/position_servo.hpp"

#include <cmath>

#include "geometry/rigid_motion.hpp"
#include "language/servoing/visual_servo.hpp"

namespace mrroc {

PositionServo::PositionServo(Robot& robot, Target target, In in, const Pose& wanted, const Pose& camera,
                             const ServoLimits& limits, double tolerance, double angular_tolerance)
    : Generator("PositionServo"),
      target_(std::move(target)),
      in_(in),
      camera_(camera),
      unwanted_(wanted.inverse()),
      tolerance_(tolerance),
      angular_tolerance_(angular_tolerance),
      robot_(&robot),
      servo_(std::make_unique<VisualServo>(robot, limits, "PositionServo")) {
  if (!target_) throw NonFatalError(ErrorCode::invalid_argument, "PositionServo without a function for the target");
  if (!is_rigid(wanted) || !is_rigid(camera))
    throw NonFatalError(ErrorCode::invalid_argument, "PositionServo: the desired or the camera's pose is not rigid");
  if (!(tolerance > 0) || !(angular_tolerance > 0))
    throw NonFatalError(ErrorCode::invalid_argument, "PositionServo: tolerances " + std::to_string(tolerance) + ", " +
                                                         std::to_string(angular_tolerance) + ", expected above 0");
}

PositionServo::~PositionServo() = default;
PositionServo::PositionServo(PositionServo&&) noexcept = default;
PositionServo& PositionServo::operator=(PositionServo&&) noexcept = default;

void PositionServo::start() { servo_->start(); }

bool PositionServo::terminal_condition() {
  const std::optional<Pose> seen = target_();
  error_.reset();
  if (!seen || !is_rigid(*seen)) return false;
  const Pose target = in_ == In::base ? *seen : robot_->state().pose * camera_ * *seen;
  const Pose way = servo_->pose().inverse() * target * unwanted_;
  error_.emplace();
  *error_ << way.translation(), rotation_vector(way.linear());
  return reached() && servo_->at_rest();
}

bool PositionServo::reached() const noexcept {
  return error_->head<3>().norm() <= tolerance_ && error_->tail<3>().norm() <= angular_tolerance_;
}

void PositionServo::next_state() {
  if (!error_) return servo_->step(std::nullopt);
  servo_->step(reached() ? Twist::Zero() : Twist(servo_->gain() * *error_));
}

}  // namespace mrroc
